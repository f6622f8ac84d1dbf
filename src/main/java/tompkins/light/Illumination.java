package tompkins.light;

import java.util.List;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;

/**
 * The light sources of a frame, and the sum of what a surface sends back of their light. One for each thread, whose
 * memory is used again for every point: a colour for each source would be most of what a picture allocates.
 */
public final class Illumination {

    private final List<LightSource> sources;
    private final Visibility visibility;
    private double red;
    private double green;
    private double blue;

    /** The light of some sources, where it is visible. */
    public Illumination(List<LightSource> sources, Visibility visibility) {
        this.sources = sources;
        this.visibility = visibility;
    }

    /** The light that a point with the given colours sends back along a ray that hit it. */
    public Colour reflected(Ray ray, Hit hit, Colour diffuse, Colour specular) {
        red = 0;
        green = 0;
        blue = 0;
        for (int i = 0; i < sources.size(); i++) {
            sources.get(i).reflect(ray, hit, diffuse, specular, this);
        }
        return new Colour(red, green, blue);
    }

    /** Adds the light of a source. */
    void add(double moreRed, double moreGreen, double moreBlue) {
        red += moreRed;
        green += moreGreen;
        blue += moreBlue;
    }

    /** Whether nothing that throws a shadow lies between a hit and the place (x, y, z). */
    boolean isClear(Hit from, double x, double y, double z) {
        return visibility.isClear(from, x, y, z);
    }
}
