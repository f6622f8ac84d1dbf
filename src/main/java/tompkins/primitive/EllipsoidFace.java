package tompkins.primitive;

import org.joml.Vector3dc;

/** An ellipsoid: the sphere of radius 1 in coordinates that count in semi-axes. */
final class EllipsoidFace extends Face {

    private final Vector3dc centre;
    private final Vector3dc first;
    private final Vector3dc second;
    private final Vector3dc third;

    /** By how much these coordinates stretch a length at most: the inverse of the shortest semi-axis. */
    private final double stretch;

    /**
     * An ellipsoid.
     *
     * @param centre its middle, relative to the centre of the rotation
     * @param first unit vector along a semi-axis, divided by the length of that
     */
    EllipsoidFace(Vector3dc centre, Vector3dc first, Vector3dc second, Vector3dc third) {
        super(0);
        this.centre = centre;
        this.first = first;
        this.second = second;
        this.third = third;
        stretch = Math.max(first.length(), Math.max(second.length(), third.length()));
    }

    private double along(TurningPath path, Vector3dc axis) {
        return axis.dot(path.x - centre.x(), path.y - centre.y(), path.z - centre.z());
    }

    /** The distance of the present place from the middle, counted in semi-axes. */
    private double size(TurningPath path) {
        return length(along(path, first), along(path, second), along(path, third));
    }

    private static double length(double x, double y, double z) {
        return Math.sqrt(x * x + y * y + z * z);
    }

    @Override
    double value(TurningPath path) {
        double size = size(path);
        return (size - 1) * (size + 1);
    }

    @Override
    double slope(TurningPath path) {
        return 2
                * (along(path, first) * first.dot(path.vx, path.vy, path.vz)
                        + along(path, second) * second.dot(path.vx, path.vy, path.vz)
                        + along(path, third) * third.dot(path.vx, path.vy, path.vz));
    }

    @Override
    double bend(TurningPath path, double reach) {
        double speed = Math.min(
                length(
                                first.dot(path.vx, path.vy, path.vz),
                                second.dot(path.vx, path.vy, path.vz),
                                third.dot(path.vx, path.vy, path.vz))
                        + stretch * path.bend * reach,
                stretch * path.speed);
        double size = Math.min(size(path) + speed * reach, stretch * (path.farthest + centre.length()));
        return 2 * (speed * speed + stretch * path.bend * size);
    }

    @Override
    double error(TurningPath path) {
        return 4 * stretch * stretch * path.rounding * (path.farthest + centre.length());
    }

    @Override
    boolean holds(TurningPath path) {
        return true;
    }
}
