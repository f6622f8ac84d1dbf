package tompkins.surface;

import java.util.List;
import tompkins.light.Illumination;
import tompkins.light.Lighting;
import tompkins.light.Sightline;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;

/** All around is dark: what still is bright glows by itself. */
final class DarkTracer implements Tracer, Lighting {

    static final Tracer DARK = new DarkTracer();

    private DarkTracer() {}

    @Override
    public Colour colour(Ray ray) {
        return Colour.BLACK;
    }

    @Override
    public Illumination illumination() {
        return new Illumination(List.of(), this, null);
    }

    @Override
    public boolean find(int source, Hit hit, Sightline sight) {
        return false;
    }

    @Override
    public boolean isClear(int source, Hit hit, Sightline sight) {
        return false;
    }
}
