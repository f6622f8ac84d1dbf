package tompkins.measure;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.camera.Camera;
import tompkins.math.Vectors;

/** Measures the conic through some points of a picture, such as the hyperbola on which a straight rod is seen. */
final class ConicMeasurement {

    private static final String DISTANCE_ONE = "at distance 1";

    /** A branch is drawn so far, in radians, from where it goes to infinity. */
    private static final double INFINITY_MARGIN = 1e-6;

    private final Projection projection;
    private final PicturePlane plane;
    private final List<Fact> facts = new ArrayList<>();

    ConicMeasurement(Projection projection) {
        this.projection = projection;
        plane = PicturePlane.of(projection.studio().camera());
    }

    /**
     * Fits a conic to points of the picture, in pixels.
     *
     * @param uncertainty by how much each of them is uncertain, in pixels
     * @throws ArithmeticException if they do not tell a conic
     */
    Measured measure(List<Vector2dc> pixels, double uncertainty) {
        List<Vector2d> points = pixels.stream().map(this::inPlane).toList();
        double pixel = pixels.stream().mapToDouble(this::pixelSize).max().orElseThrow();
        ConicFit fit = ConicFit.of(points, uncertainty * pixel);
        ConicFit.Kind kind = fit.kind();
        facts.add(new Fact.Word("shape", "shape", kind.toString()));
        add(fit, "eccentricity", "eccentricity", "", Conic::eccentricity);
        boolean hasAxes = kind != ConicFit.Kind.PARABOLA;
        add(fit, "semiLatusRectum", hasAxes ? "" : "semi-latus rectum", DISTANCE_ONE, Conic::semiLatusRectum);
        if (hasAxes) {
            add(fit, "semiMajorAxis", "semi-axis a", DISTANCE_ONE, Conic::semiMajorAxis);
            add(fit, "semiMinorAxis", "semi-axis b", DISTANCE_ONE, Conic::semiMinorAxis);
        }
        if (kind == ConicFit.Kind.HYPERBOLA) {
            add(fit, "asymptoteSlope", "slope of the asymptotes", "", Conic::asymptoteSlope);
        }
        facts.add(new Quantity(
                "axisAngle",
                "axis turned by",
                "degrees",
                axisAngle(fit.conic().towardsVertex()),
                Math.toDegrees(fit.axisUncertainty())));
        Vector2dc centre = kind == ConicFit.Kind.PARABOLA
                ? null
                : projection.position(plane.direction(fit.conic().centre()));
        if (centre != null) {
            Measurements.addPixel(facts, "centre", "centre", centre);
        }
        facts.add(new Quantity("residualInPixels", "rms deviation", "pixels", fit.residual() / pixel, uncertainty));
        return new Measured(facts, null, lines(fit.conic(), points));
    }

    private Vector2d inPlane(Vector2dc pixel) {
        Vector2d point = plane.point(projection.direction(pixel.x(), pixel.y()));
        if (point == null) {
            throw new ArithmeticException("the points of a conic must lie less than 90 degrees from the middle");
        }
        return point;
    }

    /** The size of a pixel, on the plane at distance 1: the larger of both ways. */
    private double pixelSize(Vector2dc pixel) {
        Vector2d here = inPlane(pixel);
        double across =
                inPlane(new Vector2d(pixel).add(pixel.x() > 1 ? -1 : 1, 0)).distance(here);
        double down =
                inPlane(new Vector2d(pixel).add(0, pixel.y() > 1 ? -1 : 1)).distance(here);
        return Math.max(across, down);
    }

    private void add(ConicFit fit, String key, String name, String unit, ToDoubleFunction<Conic> number) {
        facts.add(new Quantity(key, name, unit, number.applyAsDouble(fit.conic()), fit.uncertainty(number)));
    }

    /** The angle of an axis to the rows, counterclockwise, above -90 to 90 degrees. */
    private static double axisAngle(Vector2dc axis) {
        double degrees = Math.toDegrees(Math.atan2(axis.y(), axis.x()));
        return degrees > 90 ? degrees - 180 : degrees <= -90 ? degrees + 180 : degrees;
    }

    /** The branches on which there are points. */
    private List<List<Vector2dc>> lines(Conic conic, List<Vector2d> points) {
        double open = conic.openAngle();
        double end = open < Math.PI ? INFINITY_MARGIN : 0;
        List<List<Vector2dc>> lines = new ArrayList<>();
        if (points.stream().anyMatch(conic::isOnThisSide)) {
            lines.addAll(lines(conic, end - open, open - end));
        }
        if (!points.stream().allMatch(conic::isOnThisSide)) {
            lines.addAll(lines(conic, open + end, 2 * Math.PI - open - end));
        }
        return lines;
    }

    private List<List<Vector2dc>> lines(Conic conic, double from, double to) {
        return CurveTracer.lines(projection, from, to, azimuth -> {
            Vector2d point = conic.point(azimuth);
            return point.isFinite() ? projection.position(plane.direction(point)) : null;
        });
    }

    /**
     * The plane across the view direction at the distance 1 from the lens, on which a lens draws its picture: what lies
     * there at (x, y) is seen in the direction ahead + x right + y up.
     */
    private record PicturePlane(Vector3dc right, Vector3dc up, Vector3dc ahead) {

        static PicturePlane of(Camera camera) {
            return new PicturePlane(
                    camera.rightDirection(), camera.upDirection(), Vectors.unit(camera.viewDirection()));
        }

        /** The point of a direction; null if it does not lie ahead. */
        Vector2d point(Vector3dc direction) {
            double depth = direction.dot(ahead);
            return depth > 0 ? new Vector2d(direction.dot(right), direction.dot(up)).div(depth) : null;
        }

        /** The unit direction of a point. */
        Vector3d direction(Vector2dc point) {
            return new Vector3d(ahead).fma(point.x(), right).fma(point.y(), up).normalize();
        }
    }
}
