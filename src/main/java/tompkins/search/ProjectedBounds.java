package tompkins.search;

import org.joml.Vector3dc;
import tompkins.primitive.Bounds;
import tompkins.primitive.Primitive;

/**
 * A primitive as a lamp sees it.
 *
 * @param leastDistance a lower bound of its distance from the lamp; 0 or more
 * @param rectangle where it is seen
 * @param strip the same, if it is long; otherwise null
 */
record ProjectedBounds(
        Primitive primitive,
        float leastDistance,
        LightBufferProjection.Rectangle rectangle,
        LightBufferProjection.Strip strip) {

    /** A primitive as a lamp with the given view sees it. */
    static ProjectedBounds of(Primitive primitive, Vector3dc lamp, LightBufferProjection view) {
        Bounds box = primitive.bounds().widened();
        double rounding = Primitive.SLACK * (box.farthest() + lamp.length());
        float leastDistance = Math.nextDown((float) (box.distance(lamp) - rounding));
        return new ProjectedBounds(
                primitive, Math.max(0, leastDistance), view.rectangle(primitive, box), view.strip(primitive, box));
    }
}
