package tompkins.ray;

/**
 * A light ray that is traced backwards in time: from an event, in the direction in which the camera looks along it. The
 * light itself travels the other way. A plain value of the hot path, in units with c = 1.
 *
 * <p>Nobody outside this package changes a ray. Whoever is given one does not keep it: its memory is used again.
 */
public final class Ray {

    /**
     * A ray whose {@link #throughput} is below this is not followed: it brings less than a step of an 8-bit picture
     * (see the charts of the depth in docs/speed-and-accuracy.md).
     */
    public static final double FAINTEST = 1.0 / 1024;

    /** Where the ray starts. */
    public double x;

    public double y;
    public double z;

    /** Unit vector in which the ray is traced. */
    public double dx;

    public double dy;
    public double dz;

    /** When the light is at the start. */
    public double time;

    /** Time that passes per unit length: 1 for light in vacuum, the index in glass; any value in a Galilean world. */
    public double slowness;

    /** Frequency of the light in the frame of this ray, divided by its frequency in the camera frame. */
    public double frequency;

    /** Diameter, at the start, of the bundle of light that the ray stands for. */
    public double width;

    /** Growth of that diameter per unit length: the opening angle of the bundle. */
    public double spread;

    /** The largest share of the sample's light that the ray can still bring, 1 at the camera. */
    public double throughput;

    /** What the ray starts on, or null; the starting point itself is then no hit. */
    public Boundary boundary;

    /** Which part of the boundary the ray starts on. */
    public int part;

    /** How many surfaces sent the light on between the camera and this ray. */
    public int depth;

    private Ray() {}

    /** Memory for a ray, to be filled by {@link RayPacket#copy} or {@link #setShadow} again and again. */
    public static Ray blank() {
        return new Ray();
    }

    /** A ray from (x, y, z) at the given time, in the unit direction (dx, dy, dz), of zero width, in vacuum. */
    public static Ray from(double x, double y, double z, double dx, double dy, double dz, double time) {
        Ray ray = new Ray();
        ray.x = x;
        ray.y = y;
        ray.z = z;
        ray.dx = dx;
        ray.dy = dy;
        ray.dz = dz;
        ray.time = time;
        ray.slowness = 1;
        ray.frequency = 1;
        ray.throughput = 1;
        return ray;
    }

    /**
     * The same light in another frame.
     *
     * @param newSlowness slowness in the new frame
     * @param frequencyFactor frequency in the new frame divided by that in the frame of this ray
     * @param angleFactor small angles between rays are divided by it
     */
    public Ray inFrame(
            double newX,
            double newY,
            double newZ,
            double newDx,
            double newDy,
            double newDz,
            double newTime,
            double newSlowness,
            double frequencyFactor,
            double angleFactor) {
        Ray ray = copy();
        ray.x = newX;
        ray.y = newY;
        ray.z = newZ;
        ray.dx = newDx;
        ray.dy = newDy;
        ray.dz = newDz;
        ray.time = newTime;
        ray.slowness = newSlowness;
        ray.frequency *= frequencyFactor;
        ray.spread /= angleFactor;
        ray.boundary = null;
        ray.part = 0;
        return ray;
    }

    /** The same ray with its start moved in space and time. */
    public Ray moved(double byX, double byY, double byZ, double byTime) {
        Ray moved = copy();
        moved.x += byX;
        moved.y += byY;
        moved.z += byZ;
        moved.time += byTime;
        return moved;
    }

    /** The ray that goes on from a hit in a new unit direction, with a share of this ray's light. */
    public Ray bent(Hit hit, double newDx, double newDy, double newDz, double share) {
        return bent(hit, newDx, newDy, newDz, slowness, 1, share);
    }

    /**
     * As {@link #bent(Hit, double, double, double, double)}, with another slowness.
     *
     * @param angleFactor small angles between rays are divided by it
     */
    public Ray bent(
            Hit hit, double newDx, double newDy, double newDz, double newSlowness, double angleFactor, double share) {
        Ray ray = copy();
        ray.startOn(hit);
        ray.dx = newDx;
        ray.dy = newDy;
        ray.dz = newDz;
        ray.slowness = newSlowness;
        ray.width = widthAt(hit.distance);
        ray.spread /= angleFactor;
        ray.throughput *= share;
        ray.depth++;
        return ray;
    }

    /** The same ray with a share of its light. */
    public Ray dimmed(double share) {
        Ray dimmed = copy();
        dimmed.throughput *= share;
        return dimmed;
    }

    private Ray copy() {
        Ray copy = new Ray();
        copy.x = x;
        copy.y = y;
        copy.z = z;
        copy.dx = dx;
        copy.dy = dy;
        copy.dz = dz;
        copy.time = time;
        copy.slowness = slowness;
        copy.frequency = frequency;
        copy.width = width;
        copy.spread = spread;
        copy.throughput = throughput;
        copy.boundary = boundary;
        copy.part = part;
        copy.depth = depth;
        return copy;
    }

    /** The same ray beyond a hit, with a share of its light. */
    public Ray straightOn(Hit hit, double share) {
        return bent(hit, dx, dy, dz, share);
    }

    /**
     * Makes this a ray that starts at a hit in the unit direction (toX, toY, toZ), to ask whether something is in the
     * way.
     */
    public Ray setShadow(Hit hit, double toX, double toY, double toZ) {
        startOn(hit);
        dx = toX;
        dy = toY;
        dz = toZ;
        slowness = 1;
        frequency = 1;
        width = 0;
        spread = 0;
        throughput = 1;
        depth = 0;
        return this;
    }

    /** The ray of a shadow test, beyond something clear. */
    public Ray shadowBeyond(Hit hit) {
        return new Ray().setShadow(hit, dx, dy, dz);
    }

    /** Time of the light at a distance from the start: it falls with the distance. */
    public double timeAt(double distance) {
        return time - slowness * distance;
    }

    /** Diameter of the bundle at a distance from the start. */
    public double widthAt(double distance) {
        return width + spread * distance;
    }

    private void startOn(Hit hit) {
        x = hit.x;
        y = hit.y;
        z = hit.z;
        time = hit.time;
        boundary = hit.boundary;
        part = hit.part;
    }
}
