package tompkins.trace;

import tompkins.light.LightShift;
import tompkins.ray.Colour;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;
import tompkins.studio.Background;
import tompkins.studio.UniformBackground;

/**
 * The light of rays that leave all objects of the scene: its background, which depends on directions only.
 *
 * @param shift what becomes of light on its way to the camera, if it is shifted where it leaves what is seen; or null
 */
record BackgroundTracer(Background background, LightShift shift) implements EscapedLight {

    @Override
    public Colour colour(Ray ray) {
        Colour light = background.colour(ray.dx, ray.dy, ray.dz, Math.abs(ray.spread));
        return shift == null ? light : shift.seen(light, ray, 1);
    }

    @Override
    public Colour colour(RayPacket rays, int index) {
        Colour light = background.colour(rays.dx[index], rays.dy[index], rays.dz[index], Math.abs(rays.spread[index]));
        return shift == null ? light : shift.seen(light, 1 / rays.frequency[index], rays.directionLength[index]);
    }

    @Override
    public Colour evenLight() {
        return shift == null && background instanceof UniformBackground even ? even.colour() : null;
    }
}
