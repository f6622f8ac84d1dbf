package tompkins.ray;

/**
 * A light ray that is traced backwards in time: from an event, in the direction in which the camera looks along it. The
 * light itself travels the other way. A plain value of the hot path, in units with c = 1.
 *
 * <p>Nobody outside this package changes a ray. Nobody who is given a ray keeps it: its memory is used again.
 */
public final class Ray {

    /**
     * A ray whose {@link #throughput} is below this is not followed: it brings less than a step of an 8-bit picture
     * (see the charts of the depth in docs/speed-and-accuracy.md).
     */
    public static final double FAINTEST = 1.0 / 1024;

    /** The number of the frame in which the ray is given: 0 unless several frames are searched. */
    public int frame;

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

    /**
     * Length in this frame of the direction that had length 1 when the ray left the camera: a distance divided by it is
     * the same number in all frames. For light in vacuum, under the Lorentz transformation, it is the frequency.
     */
    public double directionLength;

    /** Whether this is no light but a line of events at one time of the camera, by which things are measured. */
    public boolean measures;

    /** Diameter, at the start, of the bundle of light that the ray stands for; negative beyond a focus of it. */
    public double width;

    /** Growth of that diameter per unit length: the opening angle of the bundle; below 0 it runs to a focus. */
    public double spread;

    /** The factor by which windows have divided small angles between rays, as motion does; 1 at the camera. */
    public double windowFactor;

    /** The largest fraction of the sample's light that the ray can still bring, 1 at the camera. */
    public double throughput;

    /** What becomes of the light of this ray on its way back over earlier hits, if light is shifted; else white. */
    public Colour weight = Colour.WHITE;

    /** The medium in which the ray is, where its rest frame matters because something moves through it; else null. */
    public Medium medium;

    /** What the ray starts on, or null; the starting point itself does not count as a hit. */
    public Boundary boundary;

    /** Which part of the boundary the ray starts on. */
    public int part;

    /** The surfaces at the start, where that lies on several; else null. None of them counts as a hit there. */
    public Contact contact;

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
        ray.setLine(x, y, z, dx, dy, dz, null, 0);
        ray.time = time;
        ray.slowness = 1;
        ray.frequency = 1;
        ray.directionLength = 1;
        ray.windowFactor = 1;
        ray.throughput = 1;
        return ray;
    }

    /**
     * Makes this the same light as another ray, which may be this one, in another frame.
     *
     * @param other the ray in its frame
     * @param newSlowness slowness in the new frame
     * @param frequencyFactor frequency in the new frame divided by that in the frame of this ray
     * @param lengthFactor length of the direction in the new frame, which is a unit vector in that of this ray; small
     *     angles between rays are divided by it
     * @return this
     */
    public Ray setInFrame(
            Ray other,
            double newX,
            double newY,
            double newZ,
            double newDx,
            double newDy,
            double newDz,
            double newTime,
            double newSlowness,
            double frequencyFactor,
            double lengthFactor) {
        set(other);
        setLine(newX, newY, newZ, newDx, newDy, newDz, null, 0);
        time = newTime;
        slowness = newSlowness;
        frequency *= frequencyFactor;
        directionLength *= lengthFactor;
        return narrowed(lengthFactor);
    }

    /** Moves the start in space and time. */
    public Ray move(double byX, double byY, double byZ, double byTime) {
        x += byX;
        y += byY;
        z += byZ;
        time += byTime;
        return this;
    }

    /** Makes this a line from a place in a unit direction, which starts on a part of a boundary, or on none (null). */
    public void setLine(
            double newX, double newY, double newZ, double newDx, double newDy, double newDz, Boundary on, int onPart) {
        x = newX;
        y = newY;
        z = newZ;
        dx = newDx;
        dy = newDy;
        dz = newDz;
        boundary = on;
        part = onPart;
    }

    /** The ray that goes on from a hit in a new unit direction, with a fraction of this ray's light. */
    public Ray bent(Hit hit, double newDx, double newDy, double newDz, double fraction) {
        assert Math.abs(newDx * newDx + newDy * newDy + newDz * newDz - 1) < 1e-6
                : "direction (" + newDx + ", " + newDy + ", " + newDz + ") is no unit vector, at " + hit.boundary;
        Ray ray = copy();
        ray.startOn(hit);
        if (hit.contact != null) {
            double cosineBehind = newDx * hit.normalX + newDy * hit.normalY + newDz * hit.normalZ;
            ray.contact = hit.contact.leave(hit.cosine(this) < 0 == cosineBehind < 0);
        }
        ray.measures = false;
        ray.dx = newDx;
        ray.dy = newDy;
        ray.dz = newDz;
        ray.slowness = lightSlowness();
        ray.width += ray.spread * hit.distance;
        ray.throughput *= fraction;
        ray.depth++;
        return ray;
    }

    /** The slowness of this ray; if it measures, the slowness 1 of the light that goes on where a surface bends it. */
    public double lightSlowness() {
        return measures ? 1 : slowness;
    }

    /** Gives this ray, which has just begun, another slowness. */
    public Ray slowed(double newSlowness) {
        slowness = newSlowness;
        return this;
    }

    /** Divides the small angles between the rays of the bundle of this ray, which has just begun. */
    public Ray narrowed(double angleFactor) {
        spread /= angleFactor;
        return this;
    }

    /** Notes what becomes of the light of this ray, which has just begun. */
    public Ray weighted(Colour newWeight) {
        weight = newWeight;
        return this;
    }

    /** Notes that a window has divided small angles by a factor, as motion does. */
    public Ray behindWindow(double factor) {
        windowFactor *= factor;
        return this;
    }

    /** Opens the bundle of this ray, which has just begun, by an angle; below 0 it runs to a focus. */
    public Ray opened(double angle) {
        spread += angle;
        return this;
    }

    /** Lets this be in a medium, or in none that matters. */
    public Ray in(Medium newMedium) {
        medium = newMedium;
        return this;
    }

    /** Sets what a change of frame does not know of light in a medium: its slowness, and its frequency. */
    public Ray asWave(double newSlowness, double newFrequency) {
        slowness = newSlowness;
        frequency = newFrequency;
        return this;
    }

    /** Makes the direction, of which only the unit vector is kept, longer by a factor. */
    public Ray stretched(double factor) {
        directionLength *= factor;
        return this;
    }

    /** Says in which frame this is given. */
    public Ray inFrame(int number) {
        frame = number;
        return this;
    }

    /** Leaves this ray, which has just begun, a fraction of its light. */
    public Ray dim(double fraction) {
        throughput *= fraction;
        return this;
    }

    /** The same ray with a fraction of its light. */
    public Ray dimmed(double fraction) {
        Ray dimmed = copy();
        dimmed.throughput *= fraction;
        return dimmed;
    }

    private Ray copy() {
        return new Ray().set(this);
    }

    /** Makes this equal to another ray, which may be this one. */
    public Ray set(Ray other) {
        if (other == this) {
            return this;
        }
        frame = other.frame;
        x = other.x;
        y = other.y;
        z = other.z;
        dx = other.dx;
        dy = other.dy;
        dz = other.dz;
        time = other.time;
        slowness = other.slowness;
        frequency = other.frequency;
        directionLength = other.directionLength;
        measures = other.measures;
        width = other.width;
        spread = other.spread;
        windowFactor = other.windowFactor;
        throughput = other.throughput;
        weight = other.weight;
        medium = other.medium;
        boundary = other.boundary;
        part = other.part;
        contact = other.contact;
        depth = other.depth;
        return this;
    }

    /** The same ray beyond a hit, with a fraction of its light. */
    public Ray straightOn(Hit hit, double fraction) {
        Ray ray = bent(hit, dx, dy, dz, fraction).slowed(slowness);
        ray.measures = measures;
        return ray;
    }

    /** The same ray beyond a hit that does nothing to it, on the surfaces there. */
    public Ray past(Hit hit, Contact surfaces) {
        Ray ray = copy();
        ray.startOn(hit);
        ray.contact = surfaces;
        ray.width += ray.spread * hit.distance;
        return ray;
    }

    /** The same ray as one that starts on one boundary alone, or on none if it does not start there. */
    public Ray startingOn(Boundary one) {
        Ray ray = copy();
        ray.part = partOf(one);
        ray.boundary = ray.part == Contact.NOWHERE ? null : one;
        return ray;
    }

    /** The part of a boundary on which this starts; {@link Contact#NOWHERE} if it does not. */
    public int partOf(Boundary one) {
        return boundary == one ? part : contact == null ? Contact.NOWHERE : contact.part(one);
    }

    /** Makes this a shadow ray from a hit in the unit direction (toX, toY, toZ). */
    public Ray setShadow(Hit hit, double toX, double toY, double toZ) {
        return setShadow(hit, toX, toY, toZ, 1);
    }

    /** As above, with a slowness. */
    public Ray setShadow(Hit hit, double toX, double toY, double toZ, double newSlowness) {
        startOn(hit);
        aim(toX, toY, toZ);
        slowness = newSlowness;
        measures = false;
        width = 0;
        spread = 0;
        throughput = 1;
        medium = null;
        depth = 0;
        return this;
    }

    /** Turns this shadow ray, which has just begun, into light in vacuum of another unit direction. */
    public Ray aim(double toX, double toY, double toZ) {
        dx = toX;
        dy = toY;
        dz = toZ;
        slowness = 1;
        frequency = 1;
        directionLength = 1;
        return this;
    }

    /** The ray of a shadow test, beyond something clear. */
    public Ray shadowBeyond(Hit hit) {
        return new Ray().setShadow(hit, dx, dy, dz, slowness);
    }

    /** Time of the light at a distance from the start: it falls with the distance. */
    public double timeAt(double distance) {
        return time - slowness * distance;
    }

    /** Diameter of the bundle at a distance from the start. */
    public double widthAt(double distance) {
        return Math.abs(width + spread * distance);
    }

    /** Lets this start at a place and a time. */
    public void setStart(Hit hit) {
        frame = hit.frame;
        x = hit.x;
        y = hit.y;
        z = hit.z;
        time = hit.time;
        boundary = hit.boundary;
        part = hit.part;
    }

    private void startOn(Hit hit) {
        setStart(hit);
        contact = hit.contact;
    }
}
