package tompkins.measure;

import org.joml.Vector2d;
import org.joml.Vector2dc;

/**
 * An ellipse, a parabola or a hyperbola in a plane, all by one equation: seen from the focus, with the angle f to the
 * direction of the nearest vertex, the distance is r = semiLatusRectum / (1 + eccentricity cos f). Where that is below
 * 0 it is the other branch of a hyperbola.
 *
 * @param focus the focus
 * @param towardsVertex unit vector from the focus to the nearest vertex
 * @param eccentricity 0 for a circle, 1 for a parabola, more for a hyperbola
 * @param semiLatusRectum distance of the focus from the curve, across the axis
 */
public record Conic(Vector2dc focus, Vector2dc towardsVertex, double eccentricity, double semiLatusRectum) {

    /**
     * The conic a x² + b x y + c y² + d x + e y + f = 0. No number of it is divided by what is 0 for a parabola.
     *
     * @return the conic; its numbers are NaN if it has no points, or is a pair of lines
     */
    static Conic of(double a, double b, double c, double d, double e, double f) {
        double middle = (a + c) / 2;
        double spread = Math.hypot((a - c) / 2, b / 2);
        double turn = Math.atan2(b, a - c) / 2;
        // the larger eigenvalue lies along this turn, the smaller one across it
        Axis larger = new Axis(new Vector2d(Math.cos(turn), Math.sin(turn)), middle + spread);
        Axis smaller = new Axis(new Vector2d(-Math.sin(turn), Math.cos(turn)), middle - spread);
        boolean isEllipse = larger.eigenvalue * smaller.eigenvalue > 0;
        boolean smallerIsMajor = isEllipse
                ? Math.abs(smaller.eigenvalue) < Math.abs(larger.eigenvalue)
                : squareAlong(smaller, larger, d, e, f) > squareAlong(larger, smaller, d, e, f);
        return smallerIsMajor ? along(smaller, larger, d, e, f) : along(larger, smaller, d, e, f);
    }

    private record Axis(Vector2dc direction, double eigenvalue) {

        double slope(double d, double e) {
            return d * direction.x() + e * direction.y();
        }
    }

    /** The square of eigenvalue times half axis of a possible major axis; below 0 if the curve does not meet it. */
    private static double squareAlong(Axis major, Axis minor, double d, double e, double f) {
        double along = major.slope(d, e);
        double across = minor.slope(d, e);
        return along * along / 4 + across * across * major.eigenvalue / (4 * minor.eigenvalue) - f * major.eigenvalue;
    }

    private static Conic along(Axis major, Axis minor, double d, double e, double f) {
        double sign = Math.signum(minor.eigenvalue);
        double alongSlope = sign * major.slope(d, e);
        double acrossSlope = sign * minor.slope(d, e);
        double constant = sign * f;
        double alongValue = sign * major.eigenvalue;
        double acrossValue = sign * minor.eigenvalue;
        double square = squareAlong(major, minor, d, e, f);
        double root = Math.sqrt(square);
        double eccentricity = Math.sqrt(1 - alongValue / acrossValue);
        double side = alongSlope < 0 ? -1 : 1;
        double focusAlong = Math.abs(alongValue) > acrossValue / 2
                ? (side * eccentricity * root - alongSlope / 2) / alongValue
                : (acrossSlope * acrossSlope / (4 * acrossValue) - constant - square / acrossValue)
                        / (side * eccentricity * root + alongSlope / 2);
        double focusAcross = -acrossSlope / (2 * acrossValue);
        Vector2d focus =
                new Vector2d(major.direction).mul(focusAlong).add(new Vector2d(minor.direction).mul(focusAcross));
        return new Conic(focus, new Vector2d(major.direction).mul(side), eccentricity, root / acrossValue);
    }

    /** Half of the major axis of an ellipse, or of the distance between the vertices of a hyperbola. */
    public double semiMajorAxis() {
        return semiLatusRectum / Math.abs(1 - eccentricity * eccentricity);
    }

    /**
     * Half of the minor axis of an ellipse; for a hyperbola {@link #semiMajorAxis} times the slope of its asymptotes.
     */
    public double semiMinorAxis() {
        return semiLatusRectum / Math.sqrt(Math.abs(1 - eccentricity * eccentricity));
    }

    /** The slope of the asymptotes of a hyperbola to its axis; NaN for an ellipse. */
    public double asymptoteSlope() {
        return Math.sqrt(eccentricity * eccentricity - 1);
    }

    /** The middle between both foci; not finite for a parabola. */
    public Vector2d centre() {
        double distance = eccentricity * semiLatusRectum / (1 - eccentricity * eccentricity);
        return new Vector2d(towardsVertex).mul(-distance).add(focus);
    }

    /** The point seen from the focus in a direction, in radians from that of the nearest vertex. */
    public Vector2d point(double azimuth) {
        double distance = semiLatusRectum / (1 + eccentricity * Math.cos(azimuth));
        double along = distance * Math.cos(azimuth);
        double across = distance * Math.sin(azimuth);
        return new Vector2d(
                focus.x() + along * towardsVertex.x() - across * towardsVertex.y(),
                focus.y() + along * towardsVertex.y() + across * towardsVertex.x());
    }

    /** The azimuth at which a curve that is not closed goes to infinity, in radians; pi for an ellipse. */
    public double openAngle() {
        return eccentricity > 1 ? Math.acos(-1 / eccentricity) : Math.PI;
    }

    /** Whether a point is nearer to the branch around the focus than to the other branch of a hyperbola. */
    boolean isOnThisSide(Vector2dc point) {
        return eccentricity <= 1 || point.sub(centre(), new Vector2d()).dot(towardsVertex) <= 0;
    }

    /** The same conic in a plane that is measured in smaller units, from another origin. */
    Conic scaled(double scale, Vector2dc origin) {
        return new Conic(
                new Vector2d(focus).mul(scale).add(origin), towardsVertex, eccentricity, semiLatusRectum * scale);
    }
}
