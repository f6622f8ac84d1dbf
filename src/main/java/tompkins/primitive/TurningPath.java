package tompkins.primitive;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.ray.Hit;
import tompkins.ray.Ray;

/**
 * A straight ray as it runs past objects that turn, in coordinates that turn with them and begin at the centre: a
 * curve. It knows where it is at a distance along the ray, how fast it runs there, and how strongly it bends at most on
 * the piece in question; and it notes what was found on it. Memory of one thread, used again for every ray.
 */
public final class TurningPath {

    /** The part of a primitive that turns into itself, and is met as if it rested. */
    public static final int ROUND = -1;

    private static final double ROUNDING = 0x1p-50;

    /** More than rounding leaves of a distance along the path, relative to it. */
    private static final double SAME = 1e-9;

    /** At how many places a ray is looked at: some ten thousand turns while it passes. */
    private static final int MOST_PLACES = 1 << 18;

    /** The largest speed of a point that is still below 1, whatever rounding does to its components. */
    private static final double FASTEST = 1 - 0x1p-50;

    private final Rotation rotation;
    private final double axisX;
    private final double axisY;
    private final double axisZ;

    // the ray
    private double startX;
    private double startY;
    private double startZ;
    private double dx;
    private double dy;
    private double dz;
    private double startAngle;
    private double rate;
    private double size;

    // the present place and the change of it with the distance
    double x;
    double y;
    double z;
    double vx;
    double vy;
    double vz;
    private double distance;
    private int places;

    private double entry;
    private double exit;
    private double hollowFrom;
    private double hollowTo;

    // the length of the present piece, and bounds on it
    double length;
    double farthest;
    double speed;
    double bend;
    double rounding;

    /** The ray where it meets that, as the object sees it that does not turn. */
    private final Ray turned = Ray.blank();

    /** The nearest primitive that was found, or null; its part; and its distance. */
    private Primitive found;

    private int part;
    private double foundDistance;
    private boolean shared;

    /** Memory for paths past what turns. */
    public TurningPath(Rotation rotation) {
        this.rotation = rotation;
        axisX = rotation.axis().x();
        axisY = rotation.axis().y();
        axisZ = rotation.axis().z();
    }

    /** Makes this the path of a ray, on which nothing was found yet. */
    public void begin(Ray ray) {
        startX = ray.x - rotation.centre().x();
        startY = ray.y - rotation.centre().y();
        startZ = ray.z - rotation.centre().z();
        dx = ray.dx;
        dy = ray.dy;
        dz = ray.dz;
        startAngle = rotation.angle(ray.time);
        rate = -rotation.angularSpeed() * ray.slowness;
        size = largest(ray.x, ray.y, ray.z)
                + largest(
                        rotation.centre().x(),
                        rotation.centre().y(),
                        rotation.centre().z());
        distance = Double.NaN;
        places = 0;
        forget();
    }

    /** Forgets what was found. */
    public void forget() {
        found = null;
        foundDistance = Primitive.NO_HIT;
        shared = false;
    }

    private static double largest(double x, double y, double z) {
        return Math.abs(x) + Math.abs(y) + Math.abs(z);
    }

    /** By how much everything turns while the light passes a unit of length. */
    public double turning() {
        return Math.abs(rate);
    }

    /** Goes to a distance along the ray. */
    public void go(double newDistance) {
        if (newDistance == distance) {
            return;
        }
        distance = newDistance;
        places++;
        double px = startX + distance * dx;
        double py = startY + distance * dy;
        double pz = startZ + distance * dz;
        // the velocity past what turns: d minus that of the turn
        double qx = dx - rate * (axisY * pz - axisZ * py);
        double qy = dy - rate * (axisZ * px - axisX * pz);
        double qz = dz - rate * (axisX * py - axisY * px);
        double angle = startAngle + rate * distance;
        double cosine = Math.cos(angle);
        double sine = -Math.sin(angle);
        double along = (axisX * px + axisY * py + axisZ * pz) * (1 - cosine);
        x = px * cosine + (axisY * pz - axisZ * py) * sine + axisX * along;
        y = py * cosine + (axisZ * px - axisX * pz) * sine + axisY * along;
        z = pz * cosine + (axisX * py - axisY * px) * sine + axisZ * along;
        double vAlong = (axisX * qx + axisY * qy + axisZ * qz) * (1 - cosine);
        vx = qx * cosine + (axisY * qz - axisZ * qy) * sine + axisX * vAlong;
        vy = qy * cosine + (axisZ * qx - axisX * qz) * sine + axisY * vAlong;
        vz = qz * cosine + (axisX * qy - axisY * qx) * sine + axisZ * vAlong;
    }

    /** Whether it was looked at so often that what it meets from here on is left open. */
    boolean isGivenUp() {
        return places > MOST_PLACES;
    }

    /**
     * Notes where the ray enters and leaves a cylinder around the axis, a little sooner and later than it does.
     *
     * @param low height of its start over the centre, along the axis
     * @param high that of its end
     * @param radius its radius
     * @param hollow the radius, 0 or more, of a hollow around the axis
     * @return whether it comes there at all
     */
    public boolean enters(double low, double high, double radius, double hollow) {
        double height = axisX * startX + axisY * startY + axisZ * startZ;
        double climb = axisX * dx + axisY * dy + axisZ * dz;
        double acrossX = dx - climb * axisX;
        double acrossY = dy - climb * axisY;
        double acrossZ = dz - climb * axisZ;
        double outX = startX - height * axisX;
        double outY = startY - height * axisY;
        double outZ = startZ - height * axisZ;
        double squaredSlope = acrossX * acrossX + acrossY * acrossY + acrossZ * acrossZ;
        double middle = squaredSlope > 0 ? -(outX * acrossX + outY * acrossY + outZ * acrossZ) / squaredSlope : 0;
        double nearX = outX + middle * acrossX;
        double nearY = outY + middle * acrossY;
        double nearZ = outZ + middle * acrossZ;
        double wide = radius + ROUNDING * size;
        double squaredNear = nearX * nearX + nearY * nearY + nearZ * nearZ;
        double squaredChord = wide * wide - squaredNear;
        if (squaredChord < 0) {
            return false;
        }
        double half = squaredSlope > 0 ? Math.sqrt(squaredChord / squaredSlope) : Primitive.NO_HIT;
        entry = Math.max(0, middle - half);
        exit = middle + half;
        double narrow = Math.max(0, hollow - 2 * ROUNDING * size);
        double squaredHollow = narrow * narrow - squaredNear;
        double halfHollow = squaredHollow > 0 ? Math.sqrt(squaredHollow / squaredSlope) : 0;
        hollowFrom = middle - halfHollow;
        hollowTo = middle + halfHollow;
        double margin = ROUNDING * size;
        double toLow = low - margin - height;
        double toHigh = high + margin - height;
        if (climb == 0) {
            return toLow <= 0 && toHigh >= 0 && entry < exit;
        }
        entry = Math.max(entry, (climb > 0 ? toLow : toHigh) / climb);
        exit = Math.min(exit, (climb > 0 ? toHigh : toLow) / climb);
        return entry < exit;
    }

    /** Whether a piece between the entry and the exit lies in the hollow. */
    public boolean isInHollow(double from, double to) {
        return from >= hollowFrom && to <= hollowTo;
    }

    /** Where it enters; 0 if it starts inside. */
    public double entry() {
        return entry;
    }

    /** Where it leaves. */
    public double exit() {
        return exit;
    }

    /**
     * Takes a piece of the path for the next questions.
     *
     * @param reach largest distance from the axis on it
     */
    public void take(double from, double to, double reach) {
        length = to - from;
        farthest = Math.sqrt(Math.max(squaredSize(from), squaredSize(to)));
        double turning = turning();
        speed = 1 + turning * reach;
        bend = turning * (2 + turning * reach);
        rounding = ROUNDING * (size + to + farthest);
    }

    /** By how much the speed along a unit vector changes at most: along the axis it is that of the ray. */
    double bendAlong(Vector3dc direction) {
        double acrossX = direction.y() * axisZ - direction.z() * axisY;
        double acrossY = direction.z() * axisX - direction.x() * axisZ;
        double acrossZ = direction.x() * axisY - direction.y() * axisX;
        return bend * Math.sqrt(acrossX * acrossX + acrossY * acrossY + acrossZ * acrossZ);
    }

    private double squaredSize(double at) {
        double px = startX + at * dx;
        double py = startY + at * dy;
        double pz = startZ + at * dz;
        return px * px + py * py + pz * pz;
    }

    /** The present place, in the coordinates of the tracer. */
    public double x() {
        return x + rotation.centre().x();
    }

    /** As {@link #x()}. */
    public double y() {
        return y + rotation.centre().y();
    }

    /** As {@link #x()}. */
    public double z() {
        return z + rotation.centre().z();
    }

    /** How far the present piece, of a length along the ray, may lie from its chord. */
    public double sag(double length) {
        return bend * length * length / 8 + rounding;
    }

    /** Notes a hit if it is nearer than what was found before; of equally near ones the one listed first stays. */
    public void find(Primitive primitive, int newPart, double newDistance) {
        boolean first = newDistance < foundDistance
                || newDistance == foundDistance && found != null && primitive.order() < found.order();
        boolean isNear = Math.min(newDistance, foundDistance) + SAME * (newDistance + size)
                >= Math.max(newDistance, foundDistance);
        shared = isNear || shared && !first;
        if (first) {
            found = primitive;
            part = newPart;
            foundDistance = newDistance;
        }
    }

    /** The distance up to which something at its place may lie. */
    public double reach() {
        return foundDistance + SAME * (foundDistance + size);
    }

    /** Whether something else may lie at its place. */
    public boolean isShared() {
        return shared;
    }

    /** The nearest primitive, or null. */
    public Primitive found() {
        return found;
    }

    /** Its distance, or {@link Primitive#NO_HIT}. */
    public double foundDistance() {
        return foundDistance;
    }

    /** The hit on what was found, where it is when the ray meets it, with its velocity there. */
    public Hit hit(Ray ray, Hit memory) {
        if (part == ROUND) {
            found.hit(ray, foundDistance, memory);
        } else {
            memory.set(ray, foundDistance, 0, 0, 0, found, part, null);
        }
        if (part != ROUND || memory.coordinates != null) {
            setTurned(ray, memory);
        }
        Vector3d velocity = rotation.velocity(memory.x, memory.y, memory.z);
        // far from the camera rounding moves the place
        double speed = velocity.length();
        if (speed > FASTEST) {
            velocity.mul(FASTEST / speed);
        }
        memory.run(velocity.x, velocity.y, velocity.z);
        return memory;
    }

    /** Asks the object, as it is described, for the normal and the coordinates, and turns them. */
    private void setTurned(Ray ray, Hit memory) {
        double placeX = memory.x;
        double placeY = memory.y;
        double placeZ = memory.z;
        double normalX = memory.normalX;
        double normalY = memory.normalY;
        double normalZ = memory.normalZ;
        go(foundDistance);
        double length = Math.sqrt(vx * vx + vy * vy + vz * vz);
        turned.setInFrame(ray, x(), y(), z(), vx / length, vy / length, vz / length, ray.time, 1, 1, 1);
        found.hitOn(memory.part, turned, 0, memory);
        rotation.turn(memory, startAngle + rate * foundDistance);
        boolean isKnown = part == ROUND;
        memory.set(
                ray,
                foundDistance,
                placeX,
                placeY,
                placeZ,
                isKnown ? normalX : memory.normalX,
                isKnown ? normalY : memory.normalY,
                isKnown ? normalZ : memory.normalZ,
                found,
                memory.part,
                memory.coordinates);
    }
}
