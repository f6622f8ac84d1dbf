package tompkins.primitive;

import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.surface.Surface;

/** The mantle of a cone in space. */
public final class ConePrimitive extends Primitive {

    /** The smallest radius, as a fraction of that of the base: at the tip u would change infinitely fast. */
    private static final double SMALLEST = 1e-12;

    private final Vector3d tip;
    private final Vector3d axis;
    private final double height;
    private final double baseRadius;
    private final double slope;

    /** Null if the surface asks for no coordinates. */
    private final RoundCoordinates round;

    /**
     * The mantle of an object's cone, before it is placed.
     *
     * @throws ArithmeticException if it is too large, too small or too flat to work with
     */
    public ConePrimitive(
            Described object,
            Surface surface,
            Vector3dc describedTip,
            Vector3dc baseCentre,
            double baseRadius,
            Placement placement) {
        super(object, surface);
        tip = placement.point(describedTip);
        Vector3d toBase = placement.vector(baseCentre.sub(describedTip, new Vector3d()));
        height = toBase.length();
        axis = Vectors.unit(toBase);
        this.baseRadius = baseRadius * placement.scale();
        slope = this.baseRadius / height;
        requireSquare(height);
        requireSquare(1 + slope);
        round = surface.usesCoordinates()
                ? RoundCoordinates.around(describedTip.sub(baseCentre, new Vector3d()), placement)
                : null;
    }

    /**
     * The points whose distance from the axis is {@code slope} times their height below the tip: a quadratic equation.
     * Its discriminant cancels for slender and for flat cones. With the moment m = w x d, which is the same for all
     * points of the ray, and the axis a it is {@code (slope |a x m|)^2 - (a.m)^2}.
     */
    @Override
    public double distance(Ray ray, double limit) {
        boolean again = ray.boundary == this;
        double wx = ray.x - tip.x;
        double wy = ray.y - tip.y;
        double wz = ray.z - tip.z;
        // seen from the point of the ray nearest to the tip, far cones keep their form
        double start = again ? 0 : -(wx * ray.dx + wy * ray.dy + wz * ray.dz);
        wx = Math.fma(start, ray.dx, wx);
        wy = Math.fma(start, ray.dy, wy);
        wz = Math.fma(start, ray.dz, wz);
        double mx = wy * ray.dz - wz * ray.dy;
        double my = wz * ray.dx - wx * ray.dz;
        double mz = wx * ray.dy - wy * ray.dx;
        double nx = axis.y * mz - axis.z * my;
        double ny = axis.z * mx - axis.x * mz;
        double nz = axis.x * my - axis.y * mx;
        double reach = slope * Math.sqrt(nx * nx + ny * ny + nz * nz);
        double aside = Math.abs(axis.x * mx + axis.y * my + axis.z * mz);
        if (aside > reach && !again) {
            return NO_HIT;
        }
        double rayAlong = ray.dx * axis.x + ray.dy * axis.y + ray.dz * axis.z;
        double startAlong = wx * axis.x + wy * axis.y + wz * axis.z;
        double rayX = ray.dx - rayAlong * axis.x;
        double rayY = ray.dy - rayAlong * axis.y;
        double rayZ = ray.dz - rayAlong * axis.z;
        double startX = wx - startAlong * axis.x;
        double startY = wy - startAlong * axis.y;
        double startZ = wz - startAlong * axis.z;
        double across = Math.sqrt(rayX * rayX + rayY * rayY + rayZ * rayZ);
        double a = (across - slope * rayAlong) * (across + slope * rayAlong);
        double b = startX * rayX + startY * rayY + startZ * rayZ - slope * slope * startAlong * rayAlong;
        if (again) {
            return a == 0 ? NO_HIT : within(-2 * b / a, 0, startAlong, rayAlong, limit);
        }
        double from = Math.sqrt(startX * startX + startY * startY + startZ * startZ);
        double c = (from - slope * startAlong) * (from + slope * startAlong);
        double q = -(b + Math.copySign(Math.sqrt((reach - aside) * (reach + aside)), b));
        double one = a == 0 ? NO_HIT : q / a;
        double other = q == 0 ? NO_HIT : c / q;
        double near = within(Math.min(one, other), start, startAlong, rayAlong, limit);
        return near < NO_HIT ? near : within(Math.max(one, other), start, startAlong, rayAlong, limit);
    }

    /** {@code start + further}, if that is in front, on the mantle and not beyond the limit; else {@link #NO_HIT}. */
    private double within(double further, double start, double startAlong, double rayAlong, double limit) {
        double along = startAlong + further * rayAlong;
        double distance = start + further;
        return distance > 0 && distance <= limit && along >= 0 && along <= height ? distance : NO_HIT;
    }

    @Override
    public Hit hit(Ray ray, double distance, Hit memory) {
        double x = ray.x - tip.x + distance * ray.dx;
        double y = ray.y - tip.y + distance * ray.dy;
        double z = ray.z - tip.z + distance * ray.dz;
        double along = x * axis.x + y * axis.y + z * axis.z;
        Vector3d radial = new Vector3d(x - along * axis.x, y - along * axis.y, z - along * axis.z);
        double radius = radial.length();
        if (hasSquare(radius)) {
            radial.div(radius);
        } else {
            radial.set(radial.equals(0, 0, 0) ? Vectors.firstAxis(axis) : Vectors.unit(radial));
        }
        double steepness = 1 / Math.sqrt(1 + slope * slope);
        Vector3d normal =
                new Vector3d(radial).sub(new Vector3d(axis).mul(slope)).mul(steepness);
        return memory.set(
                ray,
                distance,
                normal.x,
                normal.y,
                normal.z,
                this,
                0,
                round == null
                        ? null
                        : round.at(radial, Math.max(radius, baseRadius * SMALLEST), 1 - along / height, height));
    }

    @Override
    public List<Vector3d> rim() {
        return rim(new Vector3d(tip).fma(height, axis), axis, baseRadius);
    }

    @Override
    protected boolean isConvex() {
        return true;
    }

    @Override
    public double minimumAlong(double nx, double ny, double nz) {
        double top = nx * tip.x + ny * tip.y + nz * tip.z;
        double rise = nx * axis.x + ny * axis.y + nz * axis.z;
        double across = lengthOfCross(nx, ny, nz, axis.x, axis.y, axis.z);
        return Math.min(top, top + rise * height - baseRadius * across);
    }
}
