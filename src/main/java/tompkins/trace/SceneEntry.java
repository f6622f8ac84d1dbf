package tompkins.trace;

import tompkins.ray.Colour;
import tompkins.ray.Ray;
import tompkins.ray.RayBlock;

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
        Ray crossed = crossing == null ? ray : crossing.cross(ray);
        if (witness != null) {
            witness.crosses(crossed);
        }
        return sceneTracer.colourOf(crossed);
    }

    /** Takes each ray of a block into the scene frame; no witness is told. */
    void cross(RayBlock rays) {
        if (crossing != null) {
            crossing.cross(rays);
        }
    }

    /** The tracer of the scene frame. */
    RayTracer sceneTracer() {
        return sceneTracer;
    }
}
