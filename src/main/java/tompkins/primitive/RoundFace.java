package tompkins.primitive;

import org.joml.Vector3dc;

/**
 * A sphere, or the mantle of a cylinder or a cone: the points whose distance from an axis is a radius that grows evenly
 * along it.
 */
final class RoundFace extends Face {

    private final double baseX;
    private final double baseY;
    private final double baseZ;
    private final double axisX;
    private final double axisY;
    private final double axisZ;
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
        baseX = base.x();
        baseY = base.y();
        baseZ = base.z();
        axisX = axis.x();
        axisY = axis.y();
        axisZ = axis.z();
        this.radius = radius;
        this.slope = slope;
        this.length = length;
        baseDistance = base.length();
    }

    private double along(TurningPath path) {
        return (path.x - baseX) * axisX + (path.y - baseY) * axisY + (path.z - baseZ) * axisZ;
    }

    /** The distance of the present place from the axis. */
    private double outwards(TurningPath path, double along) {
        double px = path.x - baseX - along * axisX;
        double py = path.y - baseY - along * axisY;
        double pz = path.z - baseZ - along * axisZ;
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
                * ((path.x - baseX - pull * axisX) * path.vx
                        + (path.y - baseY - pull * axisY) * path.vy
                        + (path.z - baseZ - pull * axisZ) * path.vz);
    }

    @Override
    double bend(TurningPath path, double reach) {
        double along = along(path);
        double squaredSpeed = path.vx * path.vx + path.vy * path.vy + path.vz * path.vz;
        double climb = path.vx * axisX + path.vy * axisY + path.vz * axisZ;
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
