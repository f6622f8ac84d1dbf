package tompkins.primitive;

import org.joml.Vector3d;
import tompkins.math.Vectors;
import tompkins.ray.Boundary;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;
import tompkins.surface.Shadow;
import tompkins.surface.Surface;

/** One simple shape, placed and ready to be met by rays. Immutable once it is collected; shared by all threads. */
public abstract class Primitive implements Boundary, Cloneable {

    /** What {@link #distance} returns where there is no hit. */
    public static final double NO_HIT = Double.POSITIVE_INFINITY;

    /** No line meets a primitive more often than this, even with rounding at its edges. */
    public static final int MOST_MEETINGS = 8;

    /** Widening of squared sizes in margins. */
    static final double WIDER = 1.001;

    /** The size of every margin is below this. */
    public static final double LARGEST_MARGIN = 1e250;

    /** More than rounding leaves of a length in margins, relative to the coordinates. */
    static final double ROUNDING = 1e-6;

    /** How far rounding may move a point, relative to the largest coordinate. */
    public static final double SLACK = 1e-12;

    private final Described object;
    private final Surface surface;
    private final Shadow shadow;
    private int order;
    private double slack;
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

    /**
     * Rules out many rays at once: those with a margin below 0 surely miss this primitive, even allowing for rounding.
     * The others may hit or miss. It saves most calls of {@link #distance}. The default uses a ball around the
     * primitive; shapes may use something narrower.
     *
     * @param starts where the rays of the packet start
     * @param margins receives a number for each ray of the packet, smaller than {@link #LARGEST_MARGIN}
     * @return false if this primitive has no such margins; nothing is written then
     */
    public boolean missMargins(RayPacket rays, RayStarts starts, double[] margins) {
        Bounds bounds = bounds();
        if (bounds == null) {
            return false;
        }
        Vector3d centre = bounds.centre();
        return ballMissMargins(centre.x, centre.y, centre.z, bounds.halfDiagonal(), rays, starts, margins);
    }

    /**
     * The margins of a ball, by the distance of its centre from the line. From a single start it is a circular cone,
     * which takes a third of the time. Short loops, because the compiler makes no instructions for several rays at once
     * from a long one.
     */
    static boolean ballMissMargins(
            double x, double y, double z, double radius, RayPacket rays, RayStarts starts, double[] margins) {
        double farthest = starts.farthest() + Math.abs(x) + Math.abs(y) + Math.abs(z);
        if (!hasSquare(radius) || !hasSquare(farthest)) {
            return false;
        }
        int count = rays.count();
        double[] startX = rays.x;
        double[] startY = rays.y;
        double[] startZ = rays.z;
        double rounding = ROUNDING * farthest;
        double most = WIDER * radius * radius + rounding * rounding;
        if (starts.areOne()) {
            double fx = x - startX[0];
            double fy = y - startY[0];
            double fz = z - startZ[0];
            double constant = most - (fx * fx + fy * fy + fz * fz);
            for (int i = 0; i < count; i++) {
                double along = fx * rays.dx[i] + fy * rays.dy[i] + fz * rays.dz[i];
                margins[i] = constant + along * along;
            }
            return true;
        }
        for (int i = 0; i < count; i++) {
            margins[i] = (x - startX[i]) * rays.dx[i] + (y - startY[i]) * rays.dy[i] + (z - startZ[i]) * rays.dz[i];
        }
        for (int i = 0; i < count; i++) {
            double fx = x - startX[i];
            double fy = y - startY[i];
            double fz = z - startZ[i];
            margins[i] = most + margins[i] * margins[i] - (fx * fx + fy * fy + fz * fz);
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
        return x == 0 && y == 0 && z == 0
                ? new Vector3d(-ray.dx, -ray.dy, -ray.dz)
                : Vectors.unit(new Vector3d(x, y, z));
    }

    /** Whether products of squares of a size are neither 0 nor infinite. */
    static boolean hasSquare(double size) {
        return size > 1e-60 && size < 1e60;
    }

    /**
     * Whether a ray from a hit surely misses this primitive, if that can be decided quickly without making the ray. The
     * default: it leaves this primitive outwards, because a convex primitive is then never met again.
     */
    public boolean surelyMisses(Hit from, double dx, double dy, double dz) {
        return from.boundary == this && dx * from.normalX + dy * from.normalY + dz * from.normalZ > 0;
    }

    /** The direction in which the primitive is much longer than in others, of any length, or null. */
    public Vector3d longAxis() {
        return null;
    }

    /** The hit at a distance that {@link #distance} returned. */
    public final Hit hit(Ray ray, double distance) {
        return hit(ray, distance, Hit.blank());
    }

    /** The same, in memory that is used again. */
    public abstract Hit hit(Ray ray, double distance, Hit memory);

    /** A box that holds the primitive, or null if none does. */
    public abstract Bounds bounds();

    /**
     * The least value of n.x over the primitive, or a smaller one: it decides whether the primitive lies beyond a plane
     * with the normal n (of any length).
     */
    public abstract double minimumAlong(double nx, double ny, double nz);

    /** Whether the primitive surely lies where n.x is above a bound, even allowing for rounding. */
    public final boolean isBeyond(double nx, double ny, double nz, double bound) {
        return conservativeMinimumAlong(nx, ny, nz) > bound;
    }

    /** As {@link #minimumAlong}, even allowing for rounding. */
    public final double conservativeMinimumAlong(double nx, double ny, double nz) {
        return minimumAlong(nx, ny, nz) - slack * (Math.abs(nx) + Math.abs(ny) + Math.abs(nz));
    }

    /**
     * The inverse of the signed distance to this primitive along a line: positive in front of the ray's start, negative
     * behind it, 0 at infinity; NaN if the line misses it.
     */
    public double inverseDistance(Ray line) {
        double ahead = distance(line, NO_HIT);
        if (ahead < NO_HIT) {
            return 1 / ahead;
        }
        Ray backwards = Ray.from(line.x, line.y, line.z, -line.dx, -line.dy, -line.dz, 0);
        double behind = distance(backwards, NO_HIT);
        return behind < NO_HIT ? -1 / behind : Double.NaN;
    }

    /** Whether this primitive throws a shadow on the start of a ray, from a distance of at most {@code limit}. */
    public final boolean shadows(Ray ray, double limit) {
        if (shadow == Shadow.NEVER) {
            return false;
        }
        double distance = distance(ray, limit);
        if (shadow == Shadow.ALWAYS || distance == NO_HIT) {
            return distance < NO_HIT;
        }
        Ray rest = ray;
        double left = limit;
        for (int meeting = 0; meeting < MOST_MEETINGS && distance < NO_HIT; meeting++) {
            Hit hit = hit(rest, distance);
            if (surface.throwsShadowAt(hit)) {
                return true;
            }
            left -= distance;
            rest = rest.shadowBeyond(hit);
            distance = distance(rest, left);
        }
        return false;
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
        slack = bounds == null ? 0 : SLACK * bounds.farthest();
    }

    @Override
    public final double clockOffset() {
        return restFrame.clockOffset() - restFrame.zero().time();
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
