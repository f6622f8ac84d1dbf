package tompkins.ray;

/** Where and when a ray meets a boundary: memory of the hot path that is used again, so nobody keeps it. */
public final class Hit implements Cloneable {

    /** Position, in the frame of the ray. */
    public double x;

    public double y;
    public double z;

    /** Unit normal of the boundary, pointing out of the object (for open surfaces: to the side named as front). */
    public double normalX;

    public double normalY;
    public double normalZ;

    /** Distance from the start of the ray. */
    public double distance;

    /** Time of the hit, in the frame of the ray. */
    public double time;

    /** What is hit. */
    public Boundary boundary;

    /** Which part of the boundary: objects number their mantles, caps and faces. */
    public int part;

    /** The number of the frame in which this is given, as in {@link Ray#frame}. */
    public int frame;

    /** The ray that has hit, in this frame; null where that is not known. */
    public Ray ray;

    /** The same event in the frame in which the ray began, where it is known best; null if only one is searched. */
    public Hit event;

    private Hit memoryOfEvent;

    /** Whether the point that is hit runs in this frame, on an object that turns; its velocity means nothing else. */
    public boolean pointMoves;

    public double velocityX;
    public double velocityY;
    public double velocityZ;

    /** The surfaces at this place, if there are several; else null. */
    public Contact contact;

    /** Coordinates on the surface, or null where the surface does not ask for them. */
    public SurfaceCoordinates coordinates;

    private Hit() {}

    /** Memory for a hit, to be set again and again. */
    public static Hit blank() {
        return new Hit();
    }

    /**
     * Makes this the hit of {@code ray} on part {@code newPart} of a boundary with the given unit normal.
     *
     * @param newCoordinates coordinates on the surface at the hit, or null
     * @return this
     */
    public Hit set(
            Ray ray,
            double newDistance,
            double newNormalX,
            double newNormalY,
            double newNormalZ,
            Boundary newBoundary,
            int newPart,
            SurfaceCoordinates newCoordinates) {
        return set(
                ray,
                newDistance,
                ray.x + newDistance * ray.dx,
                ray.y + newDistance * ray.dy,
                ray.z + newDistance * ray.dz,
                newNormalX,
                newNormalY,
                newNormalZ,
                newBoundary,
                newPart,
                newCoordinates);
    }

    /** As above, for objects that know the position of the hit better than the ray does. */
    public Hit set(
            Ray ray,
            double newDistance,
            double newX,
            double newY,
            double newZ,
            double newNormalX,
            double newNormalY,
            double newNormalZ,
            Boundary newBoundary,
            int newPart,
            SurfaceCoordinates newCoordinates) {
        frame = ray.frame;
        x = newX;
        y = newY;
        z = newZ;
        normalX = newNormalX;
        normalY = newNormalY;
        normalZ = newNormalZ;
        pointMoves = false;
        distance = newDistance;
        time = ray.timeAt(newDistance);
        boundary = newBoundary;
        part = newPart;
        contact = null;
        coordinates = newCoordinates;
        return this;
    }

    /** The same hit in memory of its own. */
    public Hit copy() {
        try {
            Hit copy = (Hit) clone();
            copy.memoryOfEvent = null;
            return copy;
        } catch (CloneNotSupportedException impossible) {
            throw new AssertionError(impossible);
        }
    }

    /** Gives the place other coordinates on the surface. */
    public void locate(SurfaceCoordinates newCoordinates) {
        coordinates = newCoordinates;
    }

    /** Gives the boundary another unit normal, with which light is worked out. */
    public void shade(double newNormalX, double newNormalY, double newNormalZ) {
        normalX = newNormalX;
        normalY = newNormalY;
        normalZ = newNormalZ;
    }

    /**
     * What a clock shows that rests with the object at the hit: the object's proper time plus the offset of its clock.
     */
    public double clockReading() {
        return boundary == null ? time : boundary.clockReading(this);
    }

    /** Makes this a place and a time that belong to no object, to ask what light gets there. */
    public void setPlace(int newFrame, double newX, double newY, double newZ, double newTime) {
        frame = newFrame;
        x = newX;
        y = newY;
        z = newZ;
        time = newTime;
        boundary = null;
        part = 0;
        contact = null;
        pointMoves = false;
    }

    /** Says with which velocity the point that is hit runs. */
    public void run(double newVelocityX, double newVelocityY, double newVelocityZ) {
        pointMoves = true;
        velocityX = newVelocityX;
        velocityY = newVelocityY;
        velocityZ = newVelocityZ;
    }

    /** Gives the hit the distance that it has in another frame in which the place and the time stay the same. */
    public void stretch(double factor) {
        distance *= factor;
    }

    /** Memory for the event of this hit in the frame in which the ray began. */
    public Hit eventMemory() {
        if (memoryOfEvent == null) {
            memoryOfEvent = new Hit();
        }
        event = memoryOfEvent;
        return event;
    }

    /** Says which ray has hit, in the frame in which it began. */
    public void of(Ray hitting) {
        ray = hitting;
        event = null;
    }

    /** Cosine between the ray and the outward normal: negative where the ray comes from outside. */
    public double cosine(Ray ray) {
        return ray.dx * normalX + ray.dy * normalY + ray.dz * normalZ;
    }
}
