package tompkins.search;

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

    /** How a primitive is seen in a view. */
    static ProjectedBounds of(Primitive primitive, LightBufferProjection view) {
        Bounds box = primitive.bounds().widened();
        return new ProjectedBounds(
                primitive, view.leastDistance(box), view.rectangle(primitive, box), view.strip(primitive, box));
    }

    /** Where it is seen in some rows of a column of cells, or more; empty if it is not. */
    LightBufferProjection.Rectangle rectangle(LightBufferProjection view, int column, int row, int rows) {
        return strip == null ? rectangle : rectangle.and(view.rectangle(strip, column, row, rows));
    }
}
