package tompkins.primitive;

/**
 * A ray in coordinates in which objects rest that are no inertial frame: a curve there. It goes to a distance along the
 * ray and tells where it is and how fast it runs. Memory of one thread.
 */
public interface CurvedPath {

    /** Goes to a distance along the ray. */
    void go(double distance);

    /** The present place. */
    double x();

    /** As {@link #x()}. */
    double y();

    /** As {@link #x()}. */
    double z();

    /** The change of place with the distance. */
    double vx();

    /** As {@link #vx()}. */
    double vy();

    /** As {@link #vx()}. */
    double vz();

    /** The most by which that changes in a unit of distance. */
    double bend();

    /** More than rounding leaves of a place, at a distance. */
    double rounding(double distance);
}
