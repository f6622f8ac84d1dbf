package tompkins.trace;

import tompkins.light.LightShift;
import tompkins.ray.Colour;
import tompkins.ray.Medium;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;
import tompkins.world.FrameRoutes;

/** The light of rays that leave the objects of the camera frame: that of the scene, after the change of frame. */
final class SceneBehindCamera implements EscapedLight {

    private final FrameRoutes routes;
    private final Medium lensMedium;
    private final MovingMedium medium;
    private final RayTracer sceneTracer;
    private final LightShift shift;
    private final PathObserver observer;
    private boolean together;

    /**
     * The way into the scene.
     *
     * @param routes the ways between the frames
     * @param lensMedium a medium in which the lens rests; may be null
     * @param medium a medium of the scene through which the lens moves; may be null
     * @param shift what becomes of the light at the end, or null if it stays as it is
     * @param observer watches the rays; may be null
     */
    SceneBehindCamera(
            FrameRoutes routes,
            Medium lensMedium,
            MovingMedium medium,
            RayTracer sceneTracer,
            LightShift shift,
            PathObserver observer) {
        this.routes = routes;
        this.lensMedium = lensMedium;
        this.medium = medium;
        this.sceneTracer = sceneTracer;
        this.shift = shift;
        this.observer = observer;
    }

    /** Whether somebody watches the rays. */
    boolean isWatched() {
        return observer != null;
    }

    /** Lets rays start that have just left the camera: in its frame, and light in the medium around the lens. */
    void start(RayPacket rays, boolean measures) {
        rays.inFrame(routes.camera());
        if (observer != null && rays.count() > 0) {
            observer.starts(rays.ray(0));
        }
        if (measures) {
            rays.measure();
        } else if (lensMedium != null) {
            rays.startIn(lensMedium.index());
            rays.in(sceneTracer.keepsMedia() ? lensMedium : null);
        } else if (medium != null) {
            medium.begin(rays);
        }
    }

    /** Begins a packet of rays, which enter the scene together if all are in one medium or none, and nobody watches. */
    void begin(RayPacket rays) {
        together = observer == null && rays.isInOneMedium();
        if (together) {
            enter(rays);
            sceneTracer.begin(rays);
        }
    }

    /** What the camera sees along rays that meet nothing in the scene, if it is the same for all; otherwise null. */
    Colour evenBackground() {
        return shift == null ? sceneTracer.evenLight() : null;
    }

    /** Whether a ray of the packet may see anything but that background. */
    boolean mayMeet(int index) {
        return !together || sceneTracer.mayMeet(index);
    }

    @Override
    public Colour colour(RayPacket rays, int index) {
        if (!together) {
            return colour(rays.ray(index));
        }
        Colour light = Double.isNaN(rays.dx[index]) ? Colour.BLACK : sceneTracer.packetColour(rays, index);
        return inCameraFrame(light, rays.frequency[index], rays.directionLength[index]);
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
    private Colour inCameraFrame(Colour light, double frequency, double directionLength) {
        return shift == null ? light : shift.seen(light, 1 / frequency, directionLength);
    }

    /** Lets each ray of a packet enter the scene, all in one medium or in none. */
    private void enter(RayPacket rays) {
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
}
