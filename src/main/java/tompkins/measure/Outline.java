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
                        .map(point -> Sighting.required(plan, point).cameraDirection())
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
            List<Vector2dc> found =
                    edges.on(inside, atTheBorder(plan, inside, new Vector2d(Math.cos(angle), Math.sin(angle))), 1);
            if (found.isEmpty()) {
                throw new InvalidPropertyException(
                        "across", "inside an outline that ends in the picture", inside.x() / plan.width());
            }
            outline.add(found.get(0));
        }
        return outline;
    }

    /** Where the way from a point in a direction leaves the picture. */
    private static Vector2dc atTheBorder(RenderPlan plan, Vector2dc from, Vector2dc direction) {
        double length =
                Math.min(length(from.x(), direction.x(), plan.width()), length(from.y(), direction.y(), plan.height()));
        return from.fma(length, direction, new Vector2d());
    }

    /** How long it takes to leave the range from 0 to a size. */
    private static double length(double from, double speed, int size) {
        return speed == 0 ? Double.POSITIVE_INFINITY : ((speed > 0 ? size : 0) - from) / speed;
    }
}
