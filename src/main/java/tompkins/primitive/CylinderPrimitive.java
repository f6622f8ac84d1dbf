package tompkins.primitive;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Precise;
import tompkins.math.Vectors;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;
import tompkins.ray.SurfaceCoordinates;
import tompkins.surface.Surface;

/**
 * A cylinder in space, with or without caps. The axis is stored as it is, not as a unit vector, and its cross products
 * with the ray are formed without cancellation: a ray that runs almost along the axis keeps all its digits.
 */
public final class CylinderPrimitive extends Primitive {

    private static final int MANTLE = 0;
    private static final int START_CAP = 1;
    private static final int END_CAP = 2;

    private final double startX;
    private final double startY;
    private final double startZ;
    private final double axisX;
    private final double axisY;
    private final double axisZ;
    private final double squaredLength;
    private final double length;
    private final double radius;
    private final boolean caps;

    // null if the surface asks for no coordinates
    private final RoundCoordinates round;
    private final FaceCoordinates startFace;
    private final FaceCoordinates endFace;

    /**
     * A cylinder that is, or is part of, an object, before it is placed.
     *
     * @throws ArithmeticException if it is too large or too small to work with
     */
    public CylinderPrimitive(
            Described object,
            Surface surface,
            Vector3dc describedStart,
            Vector3dc describedEnd,
            double radius,
            boolean caps,
            Placement placement) {
        super(object, surface);
        Vector3d toEnd = describedEnd.sub(describedStart, new Vector3d());
        Vector3d start = placement.point(describedStart);
        Vector3d axis = placement.vector(toEnd);
        startX = start.x;
        startY = start.y;
        startZ = start.z;
        axisX = axis.x;
        axisY = axis.y;
        axisZ = axis.z;
        squaredLength = axis.lengthSquared();
        length = axis.length();
        this.radius = radius * placement.scale();
        requireSquare(length);
        requireSquare(length + this.radius);
        this.caps = caps;
        boolean usesCoordinates = surface.usesCoordinates();
        round = usesCoordinates ? RoundCoordinates.around(toEnd, placement) : null;
        double width = 2 * radius;
        endFace = usesCoordinates ? FaceCoordinates.across(Vectors.unit(toEnd), width, width, placement) : null;
        startFace =
                usesCoordinates ? FaceCoordinates.across(Vectors.unit(toEnd).negate(), width, width, placement) : null;
    }

    /** The centre of its start, after the placement. */
    public Vector3d start() {
        return new Vector3d(startX, startY, startZ);
    }

    /** The centre of its end, after the placement. */
    public Vector3d end() {
        return new Vector3d(startX + axisX, startY + axisY, startZ + axisZ);
    }

    /** The radius, after the placement. */
    public double radius() {
        return radius;
    }

    @Override
    public double distance(Ray ray, double limit) {
        double wx = ray.x - startX;
        double wy = ray.y - startY;
        double wz = ray.z - startZ;
        // axis x direction: its length is |axis| sin(angle between them)
        double crossX = Precise.differenceOfProducts(axisY, ray.dz, axisZ, ray.dy);
        double crossY = Precise.differenceOfProducts(axisZ, ray.dx, axisX, ray.dz);
        double crossZ = Precise.differenceOfProducts(axisX, ray.dy, axisY, ray.dx);
        double squaredCross = crossX * crossX + crossY * crossY + crossZ * crossZ;
        // distance between the ray's line and the axis, times the length of the cross product
        double offset = wx * crossX + wy * crossY + wz * crossZ;
        if (offset * offset > radius * radius * squaredCross) {
            return NO_HIT;
        }
        double alongStart = alongAxis(wx, wy, wz);
        double slope = alongAxis(ray.dx, ray.dy, ray.dz);
        double nearest = squaredCross > 0
                ? mantle(ray, wx, wy, wz, crossX, crossY, crossZ, squaredCross, Math.abs(offset), alongStart, slope)
                : nearestCap(ray, wx, wy, wz, alongStart, slope);
        return nearest <= limit ? nearest : NO_HIT;
    }

    /**
     * By the distance between the ray's line and the axis, as in {@link #distance} but without the ends. Rays from one
     * start share the product of its place and the axis.
     */
    @Override
    public boolean overlaps(RayPacket rays, boolean oneStart, double farthest, double[] overlaps) {
        double size = farthest + Math.abs(startX) + Math.abs(startY) + Math.abs(startZ);
        if (!hasSquare(radius) || !hasSquare(length) || !hasSquare(size)) {
            return false;
        }
        int count = rays.count();
        double[] x = rays.x;
        double[] y = rays.y;
        double[] z = rays.z;
        double[] dx = rays.dx;
        double[] dy = rays.dy;
        double[] dz = rays.dz;
        double reach = WIDER * radius * radius;
        double rounding = ROUNDING * size;
        double most = (reach * WIDER + rounding * rounding) * squaredLength;
        if (oneStart) {
            double wx = x[0] - startX;
            double wy = y[0] - startY;
            double wz = z[0] - startZ;
            double crossX = wy * axisZ - wz * axisY;
            double crossY = wz * axisX - wx * axisZ;
            double crossZ = wx * axisY - wy * axisX;
            for (int i = 0; i < count; i++) {
                double offset = crossX * dx[i] + crossY * dy[i] + crossZ * dz[i];
                overlaps[i] = most - offset * offset;
            }
            for (int i = 0; i < count; i++) {
                double along = axisX * dx[i] + axisY * dy[i] + axisZ * dz[i];
                overlaps[i] -= reach * along * along;
            }
            return true;
        }
        for (int i = 0; i < count; i++) {
            overlaps[i] = dx[i] * ((y[i] - startY) * axisZ - (z[i] - startZ) * axisY);
        }
        for (int i = 0; i < count; i++) {
            overlaps[i] += dy[i] * ((z[i] - startZ) * axisX - (x[i] - startX) * axisZ);
        }
        for (int i = 0; i < count; i++) {
            overlaps[i] += dz[i] * ((x[i] - startX) * axisY - (y[i] - startY) * axisX);
        }
        for (int i = 0; i < count; i++) {
            double along = axisX * dx[i] + axisY * dy[i] + axisZ * dz[i];
            overlaps[i] = most - reach * along * along - overlaps[i] * overlaps[i];
        }
        return true;
    }

    /** The nearest hit of a ray that is not parallel to the axis: on the mantle, or on a cap. */
    private double mantle(
            Ray ray,
            double wx,
            double wy,
            double wz,
            double crossX,
            double crossY,
            double crossZ,
            double squaredCross,
            double offset,
            double alongStart,
            double slope) {
        double sideX = Precise.differenceOfProducts(axisY, wz, axisZ, wy);
        double sideY = Precise.differenceOfProducts(axisZ, wx, axisX, wz);
        double sideZ = Precise.differenceOfProducts(axisX, wy, axisY, wx);
        double middle = -(sideX * crossX + sideY * crossY + sideZ * crossZ) / squaredCross;
        if (ray.boundary == this && ray.part == MANTLE) {
            double again = within(2 * middle, alongStart, slope);
            return again < NO_HIT ? again : nearestCap(ray, wx, wy, wz, alongStart, slope);
        }
        double reach = radius * Math.sqrt(squaredCross);
        // rounding may put a grazing ray beyond the reach
        double halfChord = length * Math.sqrt(Math.max(0, (reach - offset) * (reach + offset))) / squaredCross;
        double side = Math.sqrt(sideX * sideX + sideY * sideY + sideZ * sideZ);
        double product = (side - radius * length) * (side + radius * length) / squaredCross;
        double outer = middle + (middle > 0 ? halfChord : -halfChord);
        double inner = outer == 0 ? 0 : product / outer;
        double near = within(Math.min(inner, outer), alongStart, slope);
        // a ray that comes in through the mantle meets no cap before
        return near < NO_HIT
                ? near
                : Math.min(
                        within(Math.max(inner, outer), alongStart, slope),
                        nearestCap(ray, wx, wy, wz, alongStart, slope));
    }

    private double nearestCap(Ray ray, double wx, double wy, double wz, double alongStart, double slope) {
        return caps
                ? Math.min(
                        cap(ray, START_CAP, wx, wy, wz, -alongStart / slope),
                        cap(ray, END_CAP, wx, wy, wz, (squaredLength - alongStart) / slope))
                : NO_HIT;
    }

    private double alongAxis(double x, double y, double z) {
        return x * axisX + y * axisY + z * axisZ;
    }

    /** The distance, if it lies in front and its point between the ends. */
    private double within(double distance, double alongStart, double slope) {
        double along = alongStart + distance * slope;
        return distance > 0 && along >= 0 && along <= squaredLength ? distance : NO_HIT;
    }

    /** The distance of a cap's plane, if it lies in front and its point within the radius. */
    private double cap(Ray ray, int part, double wx, double wy, double wz, double distance) {
        if (!(distance > 0) || (ray.boundary == this && ray.part == part)) {
            return NO_HIT;
        }
        double fraction = part == END_CAP ? 1 : 0;
        double x = wx + distance * ray.dx - fraction * axisX;
        double y = wy + distance * ray.dy - fraction * axisY;
        double z = wz + distance * ray.dz - fraction * axisZ;
        return x * x + y * y + z * z <= radius * radius ? distance : NO_HIT;
    }

    @Override
    public Hit hit(Ray ray, double distance, Hit memory) {
        double wx = ray.x - startX;
        double wy = ray.y - startY;
        double wz = ray.z - startZ;
        double alongStart = alongAxis(wx, wy, wz);
        double slope = alongAxis(ray.dx, ray.dy, ray.dz);
        int part = caps ? part(ray, distance, wx, wy, wz, alongStart, slope) : MANTLE;
        if (part != MANTLE) {
            return capHit(ray, distance, part, memory);
        }
        double along = (alongStart + distance * slope) / squaredLength;
        Vector3d normal = unitOrFacing(
                ray,
                wx + distance * ray.dx - along * axisX,
                wy + distance * ray.dy - along * axisY,
                wz + distance * ray.dz - along * axisZ);
        return memory.set(
                ray,
                distance,
                startX + along * axisX + radius * normal.x,
                startY + along * axisY + radius * normal.y,
                startZ + along * axisZ + radius * normal.z,
                normal.x,
                normal.y,
                normal.z,
                this,
                MANTLE,
                round == null ? null : round.at(normal, radius, along, length));
    }

    /** The part that is hit at a distance. */
    private int part(Ray ray, double distance, double wx, double wy, double wz, double alongStart, double slope) {
        if (cap(ray, START_CAP, wx, wy, wz, -alongStart / slope) == distance) {
            return START_CAP;
        }
        boolean atEnd = cap(ray, END_CAP, wx, wy, wz, (squaredLength - alongStart) / slope) == distance;
        return atEnd ? END_CAP : MANTLE;
    }

    private Hit capHit(Ray ray, double distance, int part, Hit memory) {
        double scale = (part == START_CAP ? -1 : 1) / length;
        FaceCoordinates face = part == START_CAP ? startFace : endFace;
        SurfaceCoordinates coordinates = face == null
                ? null
                : face.at(
                        ray.x + distance * ray.dx - startX,
                        ray.y + distance * ray.dy - startY,
                        ray.z + distance * ray.dz - startZ);
        return memory.set(ray, distance, axisX * scale, axisY * scale, axisZ * scale, this, part, coordinates);
    }

    @Override
    protected boolean isConvex() {
        return true;
    }

    @Override
    public double minimumAlong(double nx, double ny, double nz) {
        double start = nx * startX + ny * startY + nz * startZ;
        double rise = nx * axisX + ny * axisY + nz * axisZ;
        return Math.min(start, start + rise) - radius * lengthOfCross(nx, ny, nz, axisX, axisY, axisZ) / length;
    }

    /** Its axis if it is a rod, much longer than wide; else null. */
    public Vector3d longAxis() {
        return length > 4 * radius ? new Vector3d(axisX, axisY, axisZ) : null;
    }
}
