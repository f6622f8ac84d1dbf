package tompkins.trace;

import tompkins.ray.Colour;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;
import tompkins.studio.Background;
import tompkins.studio.UniformBackground;

/** The light of rays that leave all objects of the scene: its background, which depends on directions only. */
record BackgroundTracer(Background background) implements EscapedLight {

    @Override
    public Colour colour(Ray ray) {
        return background.colour(ray.dx, ray.dy, ray.dz, Math.abs(ray.spread));
    }

    @Override
    public Colour colour(RayPacket rays, int place) {
        return background.colour(rays.dx[place], rays.dy[place], rays.dz[place], Math.abs(rays.spread[place]));
    }

    @Override
    public Colour evenLight() {
        return background instanceof UniformBackground even ? even.colour() : null;
    }
}
