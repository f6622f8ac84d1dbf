package tompkins.primitive;

import java.util.List;
import java.util.function.DoubleUnaryOperator;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Precise;
import tompkins.math.Vectors;
import tompkins.ray.Hit;
import tompkins.ray.SurfaceCoordinates;
import tompkins.spacetime.Event;
import tompkins.spacetime.TransformationLaw;

/**
 * How objects turn about an axis that rests in their frame, with a constant angular speed, in the coordinates in which
 * the tracer works. About z, the turn takes x to y. Each point runs on a circle; nothing is said of forces, or of how
 * the turning began. Immutable.
 */
public final class Rotation {

    /** More than rounding leaves of a size, relative to it. */
    static final double MARGIN = 1e-12;

    /** What the rounding of a place or of a unit vector leaves of it. */
    private static final double ROUNDING = 0x1p-50;

    /** Directions in which what is round is looked at, a radian apart. */
    private static final int DIRECTIONS = 6;

    /** Extents are looked for in wedges of at least this angle: what is round is taken for 5e-9 wider. */
    private static final double NARROWEST = 2e-4;

    private final Vector3dc centre;
    private final Vector3dc axis;
    private final double angularSpeed;
    private final double startAngle;
    private final double zeroTime;
    private final boolean slowsClocks;

    /**
     * A rotation.
     *
     * @param centre a point of the axis
     * @param axis unit vector
     * @param angularSpeed radians in a unit of time
     * @param startDegrees the angle, in degrees, at the time that is described as 0
     * @param zeroTime that time
     * @param slowsClocks whether clocks that are carried round go slower than those on the axis
     */
    public Rotation(
            Vector3dc centre,
            Vector3dc axis,
            double angularSpeed,
            double startDegrees,
            double zeroTime,
            boolean slowsClocks) {
        this.centre = centre;
        this.axis = axis;
        this.angularSpeed = angularSpeed;
        // whole turns are taken off before degrees become radians, which rounds
        startAngle = Math.toRadians(Math.IEEEremainder(startDegrees, 360));
        this.zeroTime = zeroTime;
        this.slowsClocks = slowsClocks;
    }

    /** A point of the axis. */
    public Vector3dc centre() {
        return centre;
    }

    /** The direction of the axis, a unit vector. */
    public Vector3dc axis() {
        return axis;
    }

    /** Radians in a unit of time. */
    public double angularSpeed() {
        return angularSpeed;
    }

    /** The law by which moving clocks and light are seen. */
    public TransformationLaw law() {
        return slowsClocks ? TransformationLaw.LORENTZ : TransformationLaw.GALILEAN;
    }

    /** The angle by which everything is turned at a time. */
    public double angle(double time) {
        return startAngle + angularSpeed * (time - zeroTime);
    }

    /** A vector, turned by an angle about the axis (Rodrigues' formula). */
    public Vector3d turned(Vector3dc vector, double angle) {
        double cosine = Math.cos(angle);
        double along = axis.dot(vector) * (1 - cosine);
        return axis.cross(vector, new Vector3d())
                .mul(Math.sin(angle))
                .fma(cosine, vector)
                .fma(along, axis);
    }

    /** The velocity of what is at a place: {@code w a x (x - c)}. */
    public Vector3d velocity(double x, double y, double z) {
        return axis.cross(x - centre.x(), y - centre.y(), z - centre.z(), new Vector3d())
                .mul(angularSpeed);
    }

    /** The point that is at an event, where it is described: before anything was turned; and its own time. */
    public Event described(Event event) {
        Vector3d place =
                turned(event.position().sub(centre), -angle(event.time())).add(centre);
        Vector3d velocity = velocity(event.x(), event.y(), event.z());
        double ownTime = zeroTime + ownTime(event.time(), velocity.x, velocity.y, velocity.z);
        return new Event(place.x, place.y, place.z, ownTime);
    }

    /** The time that a clock has counted which is carried round with a velocity, since the time described as 0. */
    double ownTime(double time, double velocityX, double velocityY, double velocityZ) {
        double slowing = slowsClocks ? Math.sqrt(Precise.oneMinusSquares(velocityX, velocityY, velocityZ)) : 1;
        return (time - zeroTime) * slowing;
    }

    /** Turns the normal and the coordinates of a hit on an object as it is described. */
    void turn(Hit hit, double angle) {
        Vector3d normal = turned(new Vector3d(hit.normalX, hit.normalY, hit.normalZ), angle);
        hit.shade(normal.x, normal.y, normal.z);
        SurfaceCoordinates at = hit.coordinates;
        if (at != null) {
            hit.locate(new SurfaceCoordinates(
                    at.u(),
                    at.v(),
                    turned(new Vector3d(at.uX(), at.uY(), at.uZ()), angle),
                    turned(new Vector3d(at.vX(), at.vY(), at.vZ()), angle)));
        }
    }

    /** The distance of a point from the axis. */
    double fromAxis(Vector3dc point) {
        Vector3d from = point.sub(centre, new Vector3d());
        return from.fma(-from.dot(axis), axis).length();
    }

    /** Whether a point stays where it is, but for rounding. */
    public boolean isOnAxis(Vector3dc point) {
        double size = point.length() + centre.length();
        return fromAxis(point) <= ROUNDING * size;
    }

    /** The largest distance of a point of a primitive from the axis, never less than it is. */
    public double reach(Primitive primitive) {
        Vector3d right = Vectors.firstAxis(axis);
        Vector3d up = axis.cross(right, new Vector3d());
        DoubleUnaryOperator extent = angle -> extent(
                primitive, new Vector3d(right).mul(Math.cos(angle)).add(up.mul(Math.sin(angle), new Vector3d())));
        double quarter = Math.PI / 2;
        double most = 0;
        for (int i = 0; i < 4; i++) {
            double first = extent.applyAsDouble(i * quarter);
            double last = extent.applyAsDouble((i + 1) * quarter);
            most = reach(extent, i * quarter, first, quarter, last, Math.max(most, Math.max(first, last)));
        }
        return most * (1 + MARGIN);
    }

    /**
     * The same of what lies in the directions of a wedge, if that is farther than what is known. Nothing there lies
     * beyond the two planes that bound the primitive on both sides of the wedge.
     */
    private static double reach(
            DoubleUnaryOperator extent, double angle, double first, double width, double last, double known) {
        double cosine = Math.cos(width);
        double sine = Math.sin(width);
        if (!(first > last * cosine && last > first * cosine)) {
            return known;
        }
        // where the planes meet
        double across = (last - first * cosine) / sine;
        double farthest = Math.sqrt(first * first + across * across);
        if (farthest <= known * (1 + MARGIN) || width < NARROWEST) {
            return Math.max(farthest, known);
        }
        // not at the edge, so that both parts get narrower
        double part = Math.max(width / 8, Math.min(Math.atan2(across, first), width * 7 / 8));
        double there = extent.applyAsDouble(angle + part);
        double inFirst = reach(extent, angle, first, part, there, Math.max(known, there));
        return reach(extent, angle + part, there, width - part, last, inFirst);
    }

    /**
     * Whether a convex primitive stays the same when it turns, but for rounding: it reaches equally far in directions
     * all around that have nothing to do with each other, level and slanted ones.
     */
    public boolean turnsIntoItself(Primitive primitive) {
        Bounds bounds = primitive.bounds();
        double rounding = Primitive.SLACK * (bounds.farthest() + bounds.halfDiagonal());
        Vector3d level = Vectors.firstAxis(axis);
        boolean isRound = primitive.isConvex();
        for (double slant = -1; slant <= 1; slant++) {
            Vector3d first = new Vector3d(level).fma(slant, axis);
            double reach = extent(primitive, first);
            for (int angle = 1; angle <= DIRECTIONS && isRound; angle++) {
                isRound = Math.abs(extent(primitive, turned(first, angle)) - reach) <= rounding;
            }
        }
        return isRound;
    }

    /** How far a primitive reaches from the centre in a direction. */
    private double extent(Primitive primitive, Vector3dc out) {
        return -primitive.minimumAlong(-out.x(), -out.y(), -out.z()) - centre.dot(out);
    }

    /** A distance from the axis that no point of a primitive with bounds falls below. */
    public double leastReach(Primitive primitive) {
        Bounds bounds = primitive.bounds();
        return (fromAxis(bounds.centre()) - bounds.halfDiagonal()) * (1 - MARGIN);
    }

    /** The cylinder that holds, at all times, everything that some primitives come by. */
    public CylinderPrimitive swept(List<Primitive> primitives) {
        Primitive first = primitives.get(0);
        double reach = primitives.stream().mapToDouble(this::reach).max().orElse(0);
        Vector3d down = axis.negate(new Vector3d());
        double low = -primitives.stream()
                .mapToDouble(each -> extent(each, down))
                .max()
                .orElse(0);
        double high = primitives.stream()
                .mapToDouble(each -> extent(each, axis))
                .max()
                .orElse(0);
        // a flat wheel still needs a thickness
        double margin = 1e-9 * (reach + high - low) + Primitive.SLACK * Vectors.length(centre);
        return new CylinderPrimitive(
                first.object(),
                first.surface(),
                centre.fma(low - margin, axis, new Vector3d()),
                centre.fma(high + margin, axis, new Vector3d()),
                reach + margin,
                true,
                Placement.NONE);
    }
}
