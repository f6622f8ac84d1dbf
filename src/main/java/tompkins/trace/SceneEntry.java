package tompkins.trace;

import tompkins.ray.Colour;
import tompkins.ray.Ray;

/** What is beyond the objects of the camera frame: the scene, after the change of frame if there is one. */
final class SceneEntry implements Beyond {

    private final FrameCrossing crossing;
    private final RayTracer sceneTracer;
    private final RayWitness witness;

    /** The way into the scene; the crossing is null if both frames are one, the witness may be null. */
    SceneEntry(FrameCrossing crossing, RayTracer sceneTracer, RayWitness witness) {
        this.crossing = crossing;
        this.sceneTracer = sceneTracer;
        this.witness = witness;
    }

    @Override
    public Colour colour(Ray ray) {
        return sceneTracer.colour(cross(ray));
    }

    /** The ray in the scene frame. */
    Ray cross(Ray ray) {
        Ray crossed = crossing == null ? ray : crossing.cross(ray);
        if (witness != null) {
            witness.crosses(crossed);
        }
        return crossed;
    }

    /** The tracer of the scene frame. */
    RayTracer sceneTracer() {
        return sceneTracer;
    }
}
