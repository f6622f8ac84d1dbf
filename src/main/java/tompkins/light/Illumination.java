package tompkins.light;

import java.util.List;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Padded;
import tompkins.ray.Ray;

/**
 * The light sources, and the sum of what a surface sends back of their light. One for each thread, whose memory is used
 * again for every point: a colour for each source would be most of what a picture allocates.
 */
public final class Illumination extends Padded {

    private final List<RestingLight> sources;
    private final Lighting lighting;
    private final Sightline sight = new Sightline();
    private Ray ray;
    private Hit hit;
    private int source;
    private double red;
    private double green;
    private double blue;

    /** The light of some sources, as far as it reaches the place in question. */
    public Illumination(List<RestingLight> sources, Lighting lighting) {
        this.sources = sources;
        this.lighting = lighting;
    }

    /** The light that a point with the given colours sends back along a ray that hit it. */
    public Colour reflected(Ray newRay, Hit newHit, Colour diffuse, Colour specular) {
        ray = newRay;
        hit = newHit;
        red = 0;
        green = 0;
        blue = 0;
        for (source = 0; source < sources.size(); source++) {
            sources.get(source).reflect(ray, hit, diffuse, specular, this);
        }
        return new Colour(red, green, blue);
    }

    /** The light that a point sends out by itself along a ray that hit it. */
    public Colour emitted(Ray hitting, Colour light) {
        return lighting.shifts() ? lighting.seen(light, hitting, 1) : light;
    }

    /** Adds light that a source sends to the point and the point sends on. */
    void add(double moreRed, double moreGreen, double moreBlue, double dopplerFactor) {
        if (lighting.shifts()) {
            Colour seen = lighting.seen(new Colour(moreRed, moreGreen, moreBlue), ray, dopplerFactor);
            red += seen.red();
            green += seen.green();
            blue += seen.blue();
            return;
        }
        red += moreRed;
        green += moreGreen;
        blue += moreBlue;
    }

    /** The way to the source, or null if its light does not get to the point. */
    Sightline sight() {
        return lighting.find(source, hit, sight) ? sight : null;
    }

    /** Whether nothing that throws a shadow lies on that way. */
    boolean isClear() {
        return lighting.isClear(source, hit, sight);
    }
}
