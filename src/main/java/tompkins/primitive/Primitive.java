package tompkins.primitive;

import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;
import tompkins.ray.Boundary;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;
import tompkins.spacetime.MomentaryRestFrame;
import tompkins.surface.Shadow;
import tompkins.surface.Surface;

/** One simple shape, placed and ready to be met by rays. Immutable once it is collected; shared by all threads. */
public abstract class Primitive implements Boundary, Cloneable {

    /** What {@link #distance} returns where there is no hit. */
    public static final double NO_HIT = Double.POSITIVE_INFINITY;

    /** No line meets a primitive more often than this, even with rounding at its edges. */
    public static final int MOST_MEETINGS = 8;

    /** Widening of squared sizes in overlaps. */
    static final double WIDER = 1.001;

    /** The size of every margin is below this. */
    public static final double LARGEST_OVERLAP = 1e250;

    /** More than rounding leaves of a length in overlaps, relative to the coordinates. */
    static final double ROUNDING = 1e-6;

    /** How far rounding may move a point, relative to the largest coordinate. */
    public static final double SLACK = 1e-12;

    private final Described object;
    private final Surface surface;
    private final Shadow shadow;
    private int order;

    /** A float, because each byte counts where there are a million primitives. */
    private float slack;

    private RestFrame restFrame = RestFrame.OUTERMOST;

    /** A primitive of an object as a scene file describes it. */
    protected Primitive(Described object, Surface surface) {
        this.object = object;
        this.surface = surface;
        this.shadow = surface.shadow();
    }

    /**
     * Distance to the nearest hit that lies in front of the ray's start and not beyond {@code limit}; {@link #NO_HIT}
     * if there is none. A ray that starts on this primitive does not hit its own start.
     */
    public abstract double distance(Ray ray, double limit);

    /** As {@link #distance}, of a ray that may start where this touches others: it does not hit that place either. */
    public final double distanceOff(Ray ray, double limit) {
        return distance(ray.contact == null ? ray : ray.startingOn(this), limit);
    }

    /**
     * Rules out many rays at once: those with an overlap below 0 surely miss this primitive, even allowing for
     * rounding. The others may hit or miss. It saves most calls of {@link #distance}. The default uses a ball around
     * the primitive; shapes may use something narrower.
     *
     * @param oneStart whether all rays start at one point
     * @param farthest the largest |x| + |y| + |z| of a start of a ray
     * @param overlaps receives a number for each ray of the packet, smaller than {@link #LARGEST_OVERLAP}
     * @return false if this primitive has no such overlaps; nothing is written then
     */
    public boolean overlaps(RayPacket rays, boolean oneStart, double farthest, double[] overlaps) {
        Bounds bounds = bounds();
        if (bounds == null) {
            return false;
        }
        Vector3d centre = bounds.centre();
        return ballOverlaps(centre.x, centre.y, centre.z, bounds.halfDiagonal(), rays, oneStart, farthest, overlaps);
    }

    /**
     * The overlaps of a ball, by the distance of its centre from the line. From a single start it is a circular cone,
     * which takes a third of the time. Short loops, because the compiler makes no instructions for several rays at once
     * from a long one; it would make none either in the loop of a caller, for which this method is too long.
     */
    static boolean ballOverlaps(
            double x,
            double y,
            double z,
            double radius,
            RayPacket rays,
            boolean oneStart,
            double farthest,
            double[] overlaps) {
        double size = farthest + Math.abs(x) + Math.abs(y) + Math.abs(z);
        if (!hasSquare(radius) || !hasSquare(size)) {
            return false;
        }
        int count = rays.count();
        double[] startX = rays.x;
        double[] startY = rays.y;
        double[] startZ = rays.z;
        double rounding = ROUNDING * size;
        double most = WIDER * radius * radius + rounding * rounding;
        if (oneStart) {
            double fx = x - startX[0];
            double fy = y - startY[0];
            double fz = z - startZ[0];
            double constant = most - (fx * fx + fy * fy + fz * fz);
            for (int i = 0; i < count; i++) {
                double along = fx * rays.dx[i] + fy * rays.dy[i] + fz * rays.dz[i];
                overlaps[i] = constant + along * along;
            }
            return true;
        }
        for (int i = 0; i < count; i++) {
            overlaps[i] = (x - startX[i]) * rays.dx[i] + (y - startY[i]) * rays.dy[i] + (z - startZ[i]) * rays.dz[i];
        }
        for (int i = 0; i < count; i++) {
            double fx = x - startX[i];
            double fy = y - startY[i];
            double fz = z - startZ[i];
            overlaps[i] = most + overlaps[i] * overlaps[i] - (fx * fx + fy * fy + fz * fz);
        }
        return true;
    }

    /**
     * Refuses a length whose square overflows, or is so near 0 that it loses digits.
     *
     * @throws ArithmeticException if it does
     */
    static void requireSquare(double length) {
        double square = length * length;
        if (!(square >= Double.MIN_NORMAL && square < Double.POSITIVE_INFINITY)) {
            throw new ArithmeticException("no square: " + length);
        }
    }

    /**
     * The unit vector along (x, y, z), even if its square overflows or is 0; the direction against the ray if its
     * length is 0, as on a shape that is too small at this distance for rounding to tell it from its centre.
     */
    static Vector3d unitOrFacing(Ray ray, double x, double y, double z) {
        double length = Math.sqrt(x * x + y * y + z * z);
        if (hasSquare(length)) {
            return new Vector3d(x / length, y / length, z / length);
        }
        return x == 0 && y == 0 && z == 0
                ? new Vector3d(-ray.dx, -ray.dy, -ray.dz)
                : Vectors.unit(new Vector3d(x, y, z));
    }

    /** The length of n x a. Where n is nearly along a, the root of a difference of squares would lose it. */
    static double lengthOfCross(double nx, double ny, double nz, double ax, double ay, double az) {
        double x = ny * az - nz * ay;
        double y = nz * ax - nx * az;
        double z = nx * ay - ny * ax;
        return Math.sqrt(x * x + y * y + z * z);
    }

    /** Whether products of squares of a size are neither 0 nor infinite. */
    static boolean hasSquare(double size) {
        return size > 1e-60 && size < 1e60;
    }

    /**
     * Whether this is convex, or part of the surface of something convex: a ray that leaves it outwards does not meet
     * it again. A shape that does not say so is tried again.
     */
    protected boolean isConvex() {
        return false;
    }

    /** Whether a ray from a hit surely misses this, because it leaves a convex shape outwards. */
    public boolean leavesConvexShape(Hit from, double dx, double dy, double dz) {
        return from.boundary == this && dx * from.normalX + dy * from.normalY + dz * from.normalZ > 0 && isConvex();
    }

    /** The hit at a distance that {@link #distance} returned. */
    public final Hit hit(Ray ray, double distance) {
        return hit(ray, distance, Hit.blank());
    }

    /** The same, in memory that is used again. */
    public abstract Hit hit(Ray ray, double distance, Hit memory);

    /** A box that holds the primitive, or null if none does. */
    public Bounds bounds() {
        double minX = minimumAlong(1, 0, 0);
        return minX == Double.NEGATIVE_INFINITY
                ? null
                : new Bounds(
                        minX,
                        minimumAlong(0, 1, 0),
                        minimumAlong(0, 0, 1),
                        -minimumAlong(-1, 0, 0),
                        -minimumAlong(0, -1, 0),
                        -minimumAlong(0, 0, -1));
    }

    /**
     * The least value of n.x over the primitive, or a smaller one, for a normal n of any length: it decides whether the
     * primitive lies beyond a plane, and makes the box and the cylinder around it. Minus infinity if it is endless.
     */
    public abstract double minimumAlong(double nx, double ny, double nz);

    /** As {@link #minimumAlong}, even allowing for rounding. */
    public final double conservativeMinimumAlong(double nx, double ny, double nz) {
        return minimumAlong(nx, ny, nz) - slack * (Math.abs(nx) + Math.abs(ny) + Math.abs(nz));
    }

    /** The circle or ellipse at its edge: the centre, and two conjugate radii from there; empty if it has none. */
    public List<Vector3d> rim() {
        return List.of();
    }

    /** The circle about a unit vector. */
    static List<Vector3d> rim(Vector3d centre, Vector3dc axis, double radius) {
        Vector3d first = Vectors.firstAxis(axis).mul(radius);
        return List.of(centre, first, axis.cross(first, new Vector3d()));
    }

    /** Whether this primitive throws a shadow on the start of a ray, from a distance of at most {@code limit}. */
    public boolean shadows(Ray ray, double limit) {
        if (shadow == Shadow.NEVER) {
            return false;
        }
        double distance = distance(ray, limit);
        if (distance < NO_HIT && ray.contact != null) {
            distance = distanceOff(ray, limit);
        }
        if (shadow == Shadow.ALWAYS || distance == NO_HIT) {
            return distance < NO_HIT;
        }
        Ray rest = ray;
        double left = limit;
        for (int meeting = 0; meeting < MOST_MEETINGS && distance < NO_HIT; meeting++) {
            Hit hit = hit(rest, distance);
            if (surface.throwsShadowAt(rest, hit)) {
                return true;
            }
            left -= distance;
            rest = rest.shadowBeyond(hit);
            distance = distance(rest, left);
        }
        return false;
    }

    /**
     * Whether its surface throws a shadow at a hit of a ray.
     *
     * @param hit memory that is used, if the point runs, for the frame in which it rests
     */
    public final boolean throwsShadowAt(Ray ray, Hit hit) {
        if (shadow != Shadow.BY_POINT || !hit.pointMoves) {
            return surface.throwsShadowAt(ray, hit);
        }
        // which side is met is known where the point rests
        MomentaryRestFrame point =
                new MomentaryRestFrame(hit, restFrame.rotation().law());
        Ray inside = point.enter(ray);
        point.enterHit();
        return surface.throwsShadowAt(inside, hit);
    }

    /** The same primitive at another place in memory. */
    public final Primitive copy() {
        try {
            return (Primitive) clone();
        } catch (CloneNotSupportedException impossible) {
            throw new AssertionError(impossible);
        }
    }

    /** What the user calls the object. */
    public final String description() {
        return object.description();
    }

    @Override
    public final String toString() {
        return '"' + description() + "\", " + surface;
    }

    /** The object that a scene file describes, whose primitive this is. */
    public final Described object() {
        return object;
    }

    /** What the primitive looks like. */
    public final Surface surface() {
        return surface;
    }

    /** Place in the list of primitives: among equally near hits the one listed first counts. */
    public final int order() {
        return order;
    }

    public final void setOrder(int order) {
        this.order = order;
        Bounds bounds = bounds();
        slack = bounds == null ? 0 : Math.nextUp((float) (SLACK * bounds.farthest()));
    }

    @Override
    public final double clockReading(Hit hit) {
        return hit.pointMoves
                ? restFrame.clockOffset()
                        + restFrame.rotation().ownTime(hit.time, hit.velocityX, hit.velocityY, hit.velocityZ)
                : hit.time
                        + (restFrame.clockOffset() - restFrame.properTimeZero().time());
    }

    /** A box that holds the primitive at all times; null if none does. */
    public final Bounds allBounds() {
        return restFrame.rotation() == null
                ? bounds()
                : restFrame.rotation().swept(List.of(this)).bounds();
    }

    /** The frame in which the object rests. */
    public final RestFrame restFrame() {
        return restFrame;
    }

    /** Sets the frame in which the object rests. */
    public final void setRestFrame(RestFrame frame) {
        restFrame = frame;
    }

    /** The nearer of two distances that lies in front and not beyond a limit. */
    static double nearest(double near, double far, double limit) {
        double distance = near > 0 ? near : far;
        return distance > 0 && distance <= limit ? distance : NO_HIT;
    }
}
