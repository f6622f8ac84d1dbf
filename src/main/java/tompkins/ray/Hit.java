package tompkins.ray;

/**
 * Where and when a ray meets a boundary. A plain value of the hot path, made for the nearest boundary only. Nobody who
 * is given a hit keeps it: its memory is used again.
 */
public final class Hit {

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
        x = newX;
        y = newY;
        z = newZ;
        normalX = newNormalX;
        normalY = newNormalY;
        normalZ = newNormalZ;
        distance = newDistance;
        time = ray.timeAt(newDistance);
        boundary = newBoundary;
        part = newPart;
        coordinates = newCoordinates;
        return this;
    }

    /**
     * What a clock shows that rests with the object at the hit: the object's proper time plus the offset of its clock.
     */
    public double clockReading() {
        return boundary == null ? time : time + boundary.clockOffset();
    }

    /** Makes this a place and a time that belong to no object, to ask what light gets there. */
    public void setPlace(double newX, double newY, double newZ, double newTime) {
        x = newX;
        y = newY;
        z = newZ;
        time = newTime;
        boundary = null;
        part = 0;
    }

    /** Cosine between the ray and the outward normal: negative where the ray comes from outside. */
    public double cosine(Ray ray) {
        return ray.dx * normalX + ray.dy * normalY + ray.dz * normalZ;
    }
}
