package tompkins.ray;

/** Where and when a ray meets a boundary. A plain value of the hot path, built once for the nearest boundary. */
public final class Hit {

    /** Position, in the frame of the ray. */
    public final double x;

    public final double y;
    public final double z;

    /** Unit normal of the boundary, pointing out of the object (for open surfaces: to the side named as front). */
    public final double normalX;

    public final double normalY;
    public final double normalZ;

    /** Distance from the start of the ray. */
    public final double distance;

    /** Time of the hit, in the frame of the ray. */
    public final double time;

    /** What is hit. */
    public final Boundary boundary;

    /** Which part of it: objects number their mantles, caps and faces. */
    public final int part;

    /** Coordinates on the surface, or null where the surface does not ask for them. */
    public final SurfaceCoordinates coordinates;

    /**
     * A hit of {@code ray} on part {@code part} of a boundary with the given unit normal.
     *
     * @param coordinates coordinates on the surface at the hit, or null
     */
    public Hit(
            Ray ray,
            double distance,
            double normalX,
            double normalY,
            double normalZ,
            Boundary boundary,
            int part,
            SurfaceCoordinates coordinates) {
        this(
                ray,
                distance,
                ray.x + distance * ray.dx,
                ray.y + distance * ray.dy,
                ray.z + distance * ray.dz,
                normalX,
                normalY,
                normalZ,
                boundary,
                part,
                coordinates);
    }

    /** As the other constructor, for objects that know the position of the hit better than the ray does. */
    public Hit(
            Ray ray,
            double distance,
            double x,
            double y,
            double z,
            double normalX,
            double normalY,
            double normalZ,
            Boundary boundary,
            int part,
            SurfaceCoordinates coordinates) {
        this.x = x;
        this.y = y;
        this.z = z;
        this.normalX = normalX;
        this.normalY = normalY;
        this.normalZ = normalZ;
        this.distance = distance;
        this.time = ray.timeAt(distance);
        this.boundary = boundary;
        this.part = part;
        this.coordinates = coordinates;
    }

    /** Cosine between the ray and the outward normal: negative where the ray comes from outside. */
    public double cosine(Ray ray) {
        return ray.dx * normalX + ray.dy * normalY + ray.dz * normalZ;
    }
}
