package tompkins.measure;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import tompkins.property.InvalidPropertyException;
import tompkins.trace.RenderPlan;

/** The outline of something in a picture: where the first edge is met on the way outwards in many directions. */
final class Outline {

    private static final int WAYS = 64;

    private Outline() {}

    /** The angular radius, in radians, of the circle of directions that fits points of a picture best. */
    static double angularRadius(RenderPlan plan, List<Vector2dc> points) {
        return CircleFit.of(points.stream()
                        .map(point -> Sighting.required(plan, point, 0, 0).cameraDirection())
                        .toList())
                .circle()
                .halfAngle();
    }

    /**
     * The outline around a point of a picture, in pixels.
     *
     * @throws InvalidPropertyException if there is no edge in some direction
     */
    static List<Vector2dc> around(RenderPlan plan, Vector2dc inside) {
        Edges edges = new Edges(plan);
        List<Vector2dc> outline = new ArrayList<>();
        for (int i = 0; i < WAYS; i++) {
            double angle = 2 * Math.PI * i / WAYS;
            Vector2d direction = new Vector2d(Math.cos(angle), Math.sin(angle));
            // where the way leaves the picture
            double length = Math.min(
                    length(inside.x(), direction.x, plan.width()), length(inside.y(), direction.y, plan.height()));
            List<Vector2dc> found = edges.on(inside, inside.fma(length, direction, new Vector2d()), 1);
            if (found.isEmpty()) {
                throw new InvalidPropertyException(
                        "across", "inside an outline that ends in the picture", inside.x() / plan.width());
            }
            outline.add(found.get(0));
        }
        return outline;
    }

    /** How long it takes to leave the range from 0 to a size. */
    private static double length(double from, double speed, int size) {
        return speed == 0 ? Double.POSITIVE_INFINITY : ((speed > 0 ? size : 0) - from) / speed;
    }
}
