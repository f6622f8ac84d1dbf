package tompkins.light;

import java.util.List;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Padded;
import tompkins.ray.Ray;

/**
 * The light sources, and the sum of what a surface sends back of their light. One for each thread, whose memory is
 * reused for every point: a colour for each source would be most of what a picture allocates.
 */
public final class Illumination extends Padded {

    private final RestingLight[] sources;
    private final Lighting lighting;
    private final LightShift shift;
    private final Sightline sight = new Sightline();

    /**
     * The light of some sources, as far as it reaches the point in question.
     *
     * @param shift what becomes of light on its way from the point to the camera; null if it stays as it is
     */
    public Illumination(List<RestingLight> sources, Lighting lighting, LightShift shift) {
        this.sources = sources.toArray(RestingLight[]::new);
        this.lighting = lighting;
        this.shift = shift;
    }

    /** The same sources, whose light comes by other ways. */
    public Illumination by(Lighting ways) {
        return new Illumination(List.of(sources), ways, shift);
    }

    /** The light that a point with the given colours sends back along a ray that hit it. */
    public Colour reflected(Ray ray, Hit hit, Colour diffuse, Colour specular) {
        double red = 0;
        double green = 0;
        double blue = 0;
        for (int i = 0; i < sources.length; i++) {
            RestingLight source = sources[i];
            double dull = 1;
            double shine = 0;
            double dopplerFactor = 1;
            if (source.position() != null) {
                if (!lighting.find(i, hit, sight)
                        || !sight.reaches(ray, hit, source.flash())
                        || !lighting.isClear(i, hit, sight)) {
                    continue;
                }
                dull = sight.dullness(hit);
                shine = sight.shine(ray, hit, source.highlightExponent());
                dopplerFactor = sight.dopplerFactor;
            }
            Colour light = source.colour();
            Colour highlight = source.highlightColour();
            double sentRed = diffuse.red() * light.red() * dull + specular.red() * highlight.red() * shine;
            double sentGreen = diffuse.green() * light.green() * dull + specular.green() * highlight.green() * shine;
            double sentBlue = diffuse.blue() * light.blue() * dull + specular.blue() * highlight.blue() * shine;
            if (shift != null) {
                Colour seen = shift.seen(new Colour(sentRed, sentGreen, sentBlue), ray, dopplerFactor);
                sentRed = seen.red();
                sentGreen = seen.green();
                sentBlue = seen.blue();
            }
            red += sentRed;
            green += sentGreen;
            blue += sentBlue;
        }
        return new Colour(red, green, blue);
    }

    /** The light that a point sends out by itself along a ray that hit it. */
    public Colour emitted(Ray ray, Colour light) {
        return shift == null ? light : shift.seen(light, ray, 1);
    }
}
