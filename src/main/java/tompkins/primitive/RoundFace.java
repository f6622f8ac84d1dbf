package tompkins.primitive;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * A sphere, or the mantle of a cylinder or a cone: the points whose distance from an axis is a radius that grows evenly
 * along it.
 */
final class RoundFace extends Face {

    private final Vector3d base;
    private final Vector3d axis;
    private final double radius;
    private final double slope;
    private final double length;
    private final double baseDistance;

    /**
     * A round face.
     *
     * @param base where the axis begins, relative to the centre of the rotation
     * @param axis unit vector; 0 for a sphere
     * @param radius the radius there
     * @param slope by how much it grows along the axis
     * @param length length of the axis
     */
    RoundFace(int part, Vector3dc base, Vector3dc axis, double radius, double slope, double length) {
        super(part);
        this.base = new Vector3d(base);
        this.axis = new Vector3d(axis);
        this.radius = radius;
        this.slope = slope;
        this.length = length;
        baseDistance = base.length();
    }

    private double along(TurningPath path) {
        return (path.x - base.x) * axis.x + (path.y - base.y) * axis.y + (path.z - base.z) * axis.z;
    }

    /** The distance of the present place from the axis. */
    private double outwards(TurningPath path, double along) {
        double px = path.x - base.x - along * axis.x;
        double py = path.y - base.y - along * axis.y;
        double pz = path.z - base.z - along * axis.z;
        return Math.sqrt(px * px + py * py + pz * pz);
    }

    /** {@code (w - r)(w + r)} with the distance w from the axis, which does not cancel. */
    @Override
    double value(TurningPath path) {
        double along = along(path);
        double outwards = outwards(path, along);
        double reach = radius + slope * along;
        return (outwards - reach) * (outwards + reach);
    }

    @Override
    double slope(TurningPath path) {
        double along = along(path);
        double pull = slope * (radius + slope * along) + along;
        return 2
                * ((path.x - base.x - pull * axis.x) * path.vx
                        + (path.y - base.y - pull * axis.y) * path.vy
                        + (path.z - base.z - pull * axis.z) * path.vz);
    }

    @Override
    double bend(TurningPath path, double reach) {
        double along = along(path);
        double squaredSpeed = path.vx * path.vx + path.vy * path.vy + path.vz * path.vz;
        double climb = path.vx * axis.x + path.vy * axis.y + path.vz * axis.z;
        double steepness = 1 + slope * slope;
        double drift = path.bend * reach;
        double speed = Math.min(Math.sqrt(squaredSpeed) + drift, path.speed);
        // along the axis of a cylinder and along the mantle of a cone it does not grow at all
        double square = Math.min(
                Math.abs(squaredSpeed - steepness * climb * climb) + 2 * steepness * speed * drift,
                steepness * path.speed * path.speed);
        double largest = path.farthest + baseDistance;
        double distance = Math.min(outwards(path, along) + speed * reach, largest);
        double width = Math.min(Math.abs(radius + slope * along) + slope * speed * reach, radius + slope * largest);
        return 2 * (square + path.bend * (distance + slope * width));
    }

    @Override
    double error(TurningPath path) {
        double distance = path.farthest + baseDistance;
        return 2 * path.rounding * (1 + slope) * (distance + reach(distance));
    }

    private double reach(double distance) {
        return radius + slope * distance;
    }

    @Override
    boolean holds(TurningPath path) {
        double along = along(path);
        return along >= 0 && along <= length;
    }
}
