package tompkins.primitive;

/**
 * A face of a shape as a function of place that is 0 on it, to be met by a ray that is a curve among what turns. No
 * root of the function is missed: a bound of its second derivative says where there is none, and where there is one at
 * most. Places are relative to the centre of the rotation.
 */
public abstract sealed class Face permits RoundFace, CapFace, EllipsoidFace, FlatFace {

    /** Steps towards a root that is alone between two places. */
    private static final int MOST_STEPS = 100;

    private static final double TOUCHING = 0x1p-51;

    private final int part;

    Face(int part) {
        this.part = part;
    }

    /** The number of the part of the primitive. */
    public final int part() {
        return part;
    }

    /** The function at the present place of a path. */
    abstract double value(TurningPath path);

    /** How fast it grows there along the path. */
    abstract double slope(TurningPath path);

    /**
     * The most by which that changes in a unit of distance, near the present place. Where it is far above the truth, a
     * ray that runs along the face is cut into very many pieces.
     *
     * @param reach how near, to both sides
     */
    abstract double bend(TurningPath path, double reach);

    /** The most that rounding leaves of the function, on that piece. */
    abstract double error(TurningPath path);

    /** Whether the present place, where the function is 0, belongs to the face. */
    abstract boolean holds(TurningPath path);

    /** The first distance on a piece of a path at which it meets the face; {@link Primitive#NO_HIT} if none. */
    public final double first(TurningPath path, double from, double to) {
        return from < to ? first(path, from, to, error(path)) : Primitive.NO_HIT;
    }

    private double first(TurningPath path, double from, double to, double error) {
        double half = (to - from) / 2;
        double middle = from + half;
        path.go(middle);
        double slope = Math.abs(slope(path));
        double bend = bend(path, half);
        if (Math.abs(value(path)) > (slope + bend * half / 2) * half + error) {
            return Primitive.NO_HIT;
        }
        if (slope > bend * half) {
            return root(path, from, to);
        }
        // the function is no more than rounding on this piece, or too many pieces were looked at
        if (bend * half * half <= error || half <= TOUCHING * to || path.isGivenUp()) {
            return Primitive.NO_HIT;
        }
        double near = first(path, from, middle, error);
        return near < Primitive.NO_HIT ? near : first(path, middle, to, error);
    }

    /** The root between two places between which the function grows or falls all the way. */
    private double root(TurningPath path, double from, double to) {
        path.go(from);
        boolean below = value(path) < 0;
        path.go(to);
        if (value(path) < 0 == below) {
            return Primitive.NO_HIT;
        }
        double low = from;
        double high = to;
        double at = from + (to - from) / 2;
        for (int step = 0; step < MOST_STEPS; step++) {
            path.go(at);
            double value = value(path);
            if (value < 0 == below) {
                low = at;
            } else {
                high = at;
            }
            double next = at - value / slope(path);
            if (!(next >= low && next <= high)) {
                next = low + (high - low) / 2;
            }
            boolean done = Math.abs(next - at) <= Math.ulp(at);
            at = next;
            if (done) {
                break;
            }
        }
        path.go(at);
        return at > 0 && holds(path) ? at : Primitive.NO_HIT;
    }

    /** The distance up to which a path that starts on the face surely does not meet it again. */
    public final double leaving(TurningPath path) {
        path.go(0);
        double bend = bend(path, path.length);
        return bend > 0 ? Math.max(Math.abs(slope(path)) / bend, Math.sqrt(8 * error(path) / bend)) : Primitive.NO_HIT;
    }
}
