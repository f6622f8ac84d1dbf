package tompkins.surface;

import java.util.List;
import tompkins.light.Illumination;
import tompkins.ray.Colour;
import tompkins.ray.Ray;

/** All around is dark: what still is bright glows by itself. */
final class DarkTracer implements Tracer {

    static final Tracer DARK = new DarkTracer();

    private DarkTracer() {}

    @Override
    public Colour colour(Ray ray) {
        return Colour.BLACK;
    }

    @Override
    public Illumination illumination() {
        return new Illumination(List.of(), null);
    }
}
