package tompkins.ray;

/**
 * A light ray that is traced backwards in time: from an event, in the direction in which the camera looks along it. The
 * light itself travels the other way. A plain value of the hot path, in units with c = 1.
 *
 * <p>Nobody outside this package changes a ray. Whoever is given one does not keep it: its memory is used again.
 */
public final class Ray {

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

    /** Time that passes per unit length: 1 for light in vacuum; other values only in a Galilean world. */
    public double slowness;

    /** Frequency of the light in the frame of this ray, divided by its frequency in the camera frame. */
    public double frequency;

    /** Diameter, at the start, of the bundle of light that the ray stands for. */
    public double width;

    /** Growth of that diameter per unit length: the opening angle of the bundle. */
    public double spread;

    /** The largest share of the sample's light that the ray can still bring, 1 at the camera. */
    public double weight;

    /** What the ray starts on, or null; the starting point itself is then no hit. */
    public Boundary boundary;

    /** Which part of the boundary the ray starts on. */
    public int part;

    /** How many surfaces sent the light on between the camera and this ray. */
    public int generation;

    private Ray() {}

    /** Memory for a ray, to be filled by {@link RayBlock#copy} or {@link #setShadow} again and again. */
    public static Ray blank() {
        return new Ray();
    }

    private Ray set(
            double newX,
            double newY,
            double newZ,
            double newDx,
            double newDy,
            double newDz,
            double newTime,
            double newSlowness,
            double newFrequency,
            double newWidth,
            double newSpread,
            double newWeight,
            Boundary newBoundary,
            int newPart,
            int newGeneration) {
        x = newX;
        y = newY;
        z = newZ;
        dx = newDx;
        dy = newDy;
        dz = newDz;
        time = newTime;
        slowness = newSlowness;
        frequency = newFrequency;
        width = newWidth;
        spread = newSpread;
        weight = newWeight;
        boundary = newBoundary;
        part = newPart;
        generation = newGeneration;
        return this;
    }

    /** A ray that leaves the camera at (x, y, z) at the given time, in the unit direction (dx, dy, dz), free of width. */
    public static Ray fromCamera(double x, double y, double z, double dx, double dy, double dz, double time) {
        return fromCamera(x, y, z, dx, dy, dz, time, 0);
    }

    /** As above, for a bundle with the given opening angle (the angle that one pixel sees, in radians). */
    public static Ray fromCamera(
            double x, double y, double z, double dx, double dy, double dz, double time, double spread) {
        return new Ray().set(x, y, z, dx, dy, dz, time, 1, 1, 0, spread, 1, null, 0, 0);
    }

    /**
     * The same light in another frame.
     *
     * @param newSlowness slowness in the new frame
     * @param frequencyFactor frequency in the new frame divided by that in the frame of this ray; angles shrink by it
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
            double frequencyFactor) {
        return new Ray()
                .set(
                        newX,
                        newY,
                        newZ,
                        newDx,
                        newDy,
                        newDz,
                        newTime,
                        newSlowness,
                        frequency * frequencyFactor,
                        width,
                        spread / frequencyFactor,
                        weight,
                        null,
                        0,
                        generation);
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
        return from(hit, newDx, newDy, newDz, slowness, weight * share, generation + 1);
    }

    /** As {@link #bent(Hit, double, double, double, double)}, with another slowness. */
    public Ray bent(Hit hit, double newDx, double newDy, double newDz, double newSlowness, double share) {
        return from(hit, newDx, newDy, newDz, newSlowness, weight * share, generation + 1);
    }

    /** The same ray with a share of its light. */
    public Ray dimmed(double share) {
        Ray dimmed = copy();
        dimmed.weight *= share;
        return dimmed;
    }

    /** The same ray with its opening angle divided by a factor. */
    public Ray narrowed(double factor) {
        Ray narrowed = copy();
        narrowed.spread /= factor;
        return narrowed;
    }

    private Ray copy() {
        return new Ray()
                .set(x, y, z, dx, dy, dz, time, slowness, frequency, width, spread, weight, boundary, part, generation);
    }

    /** The same ray beyond a hit, with a share of its light. */
    public Ray straightOn(Hit hit, double share) {
        return from(hit, dx, dy, dz, slowness, weight * share, generation + 1);
    }

    /** Makes this a ray that starts at a hit in the unit direction (toX, toY, toZ), to ask whether something is in the way. */
    public Ray setShadow(Hit hit, double toX, double toY, double toZ) {
        return set(hit.x, hit.y, hit.z, toX, toY, toZ, hit.time, 1, 1, 0, 0, 1, hit.boundary, hit.part, 0);
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

    private Ray from(
            Hit hit,
            double newDx,
            double newDy,
            double newDz,
            double newSlowness,
            double newWeight,
            int newGeneration) {
        return new Ray()
                .set(
                        hit.x,
                        hit.y,
                        hit.z,
                        newDx,
                        newDy,
                        newDz,
                        hit.time,
                        newSlowness,
                        frequency,
                        widthAt(hit.distance),
                        spread,
                        newWeight,
                        hit.boundary,
                        hit.part,
                        newGeneration);
    }
}
