package tompkins.trace;

import tompkins.ray.Colour;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;
import tompkins.studio.Background;

/** What is beyond the objects of the scene: its background, which depends on directions only. */
record BackgroundTracer(Background background) implements Beyond {

    @Override
    public Colour colour(Ray ray) {
        return background.colour(ray.dx, ray.dy, ray.dz);
    }

    @Override
    public Colour colour(RayPacket rays, int place) {
        return background.colour(rays.dx[place], rays.dy[place], rays.dz[place]);
    }
}
