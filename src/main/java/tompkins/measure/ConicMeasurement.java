package tompkins.measure;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.joml.Vector2d;
import org.joml.Vector2dc;

/** Measures the conic through some places of a picture, such as the hyperbola on which a straight rod is seen. */
final class ConicMeasurement {

    private static final String DISTANCE_ONE = "at distance 1";

    /** A branch is drawn so far, in radians, from where it goes to infinity. */
    private static final double INFINITY_MARGIN = 1e-6;

    private final Projection projection;
    private final PicturePlane plane;
    private final List<Quantity> quantities = new ArrayList<>();

    ConicMeasurement(Projection projection) {
        this.projection = projection;
        plane = PicturePlane.of(projection.studio().camera());
    }

    /**
     * Fits a conic to places, in pixels.
     *
     * @param placeUncertainty by how much a place is uncertain, in pixels
     * @throws ArithmeticException if they do not tell a conic
     */
    Measured measure(List<Vector2dc> places, double placeUncertainty) {
        List<Vector2d> points = places.stream().map(this::inPlane).toList();
        double pixel = places.stream().mapToDouble(this::pixel).max().orElseThrow();
        ConicFit fit = ConicFit.of(points, placeUncertainty * pixel);
        ConicFit.Kind kind = fit.kind();
        add(fit, "eccentricity", "", Conic::eccentricity);
        add(fit, "semiLatusRectum", DISTANCE_ONE, Conic::semiLatusRectum);
        if (kind != ConicFit.Kind.PARABOLA) {
            add(fit, "semiMajorAxis", DISTANCE_ONE, Conic::semiMajorAxis);
            add(fit, "semiMinorAxis", DISTANCE_ONE, Conic::semiMinorAxis);
        }
        if (kind == ConicFit.Kind.HYPERBOLA) {
            add(fit, "asymptoteSlope", "", Conic::asymptoteSlope);
        }
        quantities.add(new Quantity(
                "axisAngle", "degrees", axisAngle(fit.conic().towardsVertex()), Math.toDegrees(fit.axisUncertainty())));
        Vector2dc centre = kind == ConicFit.Kind.PARABOLA
                ? null
                : projection.place(plane.direction(fit.conic().centre()));
        if (centre != null) {
            quantities.add(Quantity.exact("centrePixelX", "pixels", centre.x() - 0.5));
            quantities.add(Quantity.exact("centrePixelY", "pixels", centre.y() - 0.5));
        }
        quantities.add(Quantity.exact("residualInPixels", "pixels", fit.residual() / pixel));
        return new Measured(MeasureKind.CONIC, kind, quantities, null, lines(fit.conic(), points));
    }

    private Vector2d inPlane(Vector2dc place) {
        Vector2d point = plane.place(projection.direction(place.x(), place.y()));
        if (point == null) {
            throw new ArithmeticException("the points of a conic must lie less than 90 degrees from the middle");
        }
        return point;
    }

    /** The size of a pixel at a place, on the plane at distance 1: the larger of both ways. */
    private double pixel(Vector2dc place) {
        Vector2d here = inPlane(place);
        double across =
                inPlane(new Vector2d(place).add(place.x() > 1 ? -1 : 1, 0)).distance(here);
        double down =
                inPlane(new Vector2d(place).add(0, place.y() > 1 ? -1 : 1)).distance(here);
        return Math.max(across, down);
    }

    private void add(ConicFit fit, String key, String unit, ToDoubleFunction<Conic> number) {
        quantities.add(new Quantity(key, unit, number.applyAsDouble(fit.conic()), fit.uncertainty(number)));
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
            Vector2d place = conic.place(azimuth);
            return place.isFinite() ? projection.place(plane.direction(place)) : null;
        });
    }
}
