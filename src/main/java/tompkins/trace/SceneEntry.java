package tompkins.trace;

import tompkins.ray.Colour;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;
import tompkins.world.FrameCrossing;

/** What is beyond the objects of the camera frame: the scene, after the change of frame. */
final class SceneEntry implements Beyond {

    private final FrameCrossing crossing;
    private final RayTracer sceneTracer;
    private final LightShift shift;
    private final PathObserver observer;

    /**
     * The way into the scene.
     *
     * @param crossing the change of frame
     * @param shift what becomes of the light, or null if it stays as it is
     * @param observer watches the rays; may be null
     */
    SceneEntry(FrameCrossing crossing, RayTracer sceneTracer, LightShift shift, PathObserver observer) {
        this.crossing = crossing;
        this.sceneTracer = sceneTracer;
        this.shift = shift;
        this.observer = observer;
    }

    @Override
    public Colour colour(Ray ray) {
        Ray crossed = crossing.cross(ray);
        if (Double.isNaN(crossed.dx)) {
            // light that stands still in the scene has come from nowhere
            return Colour.BLACK;
        }
        if (observer != null) {
            observer.crosses(crossed);
        }
        return inCameraFrame(sceneTracer.colourOf(crossed), crossed.frequency);
    }

    /**
     * The colour in the camera frame of light from the scene.
     *
     * @param frequency that of its ray: in the scene frame divided by that in the camera frame
     */
    Colour inCameraFrame(Colour light, double frequency) {
        return shift == null || sceneTracer.shifts() ? light : shift.seen(light, 1 / frequency);
    }

    /** Takes each ray of a packet into the scene frame; the observer is not told. */
    void cross(RayPacket rays) {
        crossing.cross(rays);
    }

    /** The tracer of the scene frame. */
    RayTracer sceneTracer() {
        return sceneTracer;
    }
}
