package tompkins.trace;

import tompkins.light.LightShift;
import tompkins.ray.Colour;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;
import tompkins.world.FrameRoutes;

/** The light of rays that leave the objects of the camera frame: that of the scene, after the change of frame. */
final class SceneBehindCamera implements EscapedLight {

    private final FrameRoutes routes;
    private final MovingMedium medium;
    private final RayTracer sceneTracer;
    private final LightShift shift;
    private final PathObserver observer;

    /**
     * The way into the scene.
     *
     * @param routes the ways between the frames
     * @param medium a medium of the scene in which the lens is; may be null
     * @param shift what becomes of the light at the end, or null if it stays as it is
     * @param observer watches the rays; may be null
     */
    SceneBehindCamera(
            FrameRoutes routes, MovingMedium medium, RayTracer sceneTracer, LightShift shift, PathObserver observer) {
        this.routes = routes;
        this.medium = medium;
        this.sceneTracer = sceneTracer;
        this.shift = shift;
        this.observer = observer;
    }

    @Override
    public Colour colour(Ray ray) {
        Ray entered = enter(ray, Ray.blank());
        if (Double.isNaN(entered.dx)) {
            // light at rest in the scene has come from nowhere
            return Colour.BLACK;
        }
        if (observer != null) {
            observer.crosses(routes.transform(entered, 0, Ray.blank()));
        }
        return inCameraFrame(sceneTracer.colourOf(entered), entered.frequency, entered.directionLength);
    }

    /**
     * Makes {@code memory} the ray where it enters the scene: in the scene frame, or in that of the medium in which it
     * is.
     */
    private Ray enter(Ray ray, Ray memory) {
        if (ray.medium == null) {
            return routes.transform(ray, 0, memory);
        }
        Ray entered = medium != null && medium.holds(ray.medium) ? medium.enter(ray, memory) : memory.set(ray);
        return sceneTracer.keepsMedia() ? entered : entered.in(null);
    }

    /**
     * The colour in the camera frame of light from the scene.
     *
     * @param frequency that of its ray: in the scene frame divided by that in the camera frame
     * @param directionLength that of its ray
     */
    Colour inCameraFrame(Colour light, double frequency, double directionLength) {
        return shift == null ? light : shift.seen(light, 1 / frequency, directionLength);
    }

    /**
     * What the camera sees along each ray that meets nothing in the scene, if it is the same for all; otherwise null.
     */
    Colour evenBackground() {
        return shift == null ? sceneTracer.evenLight() : null;
    }

    /** Lets each ray of a packet enter the scene, all in one medium or in none; the observer is not told. */
    void enter(RayPacket rays) {
        if (rays.medium(0) == null) {
            routes.transform(rays, 0);
            return;
        }
        Ray start = Ray.blank();
        Ray memory = Ray.blank();
        for (int i = 0; i < rays.count(); i++) {
            rays.set(i, enter(rays.copy(i, start), memory));
        }
        rays.inFrame(memory.frame);
    }

    /** The tracer of the scene frame. */
    RayTracer sceneTracer() {
        return sceneTracer;
    }
}
