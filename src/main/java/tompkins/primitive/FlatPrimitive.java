package tompkins.primitive;

import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.SurfaceCoordinates;
import tompkins.surface.Surface;

/**
 * A piece of a plane with coordinates (u, v): {@code x = corner + u U + v V}. u and v decide what belongs to the piece.
 */
public sealed class FlatPrimitive extends Primitive permits ShadedTriangle {

    /** Which part of the plane belongs to the piece. */
    public enum Outline {
        /** 0 to 1 in both directions. */
        PARALLELOGRAM,
        /** The half of the parallelogram at the corner. */
        TRIANGLE,
        /** The ellipse that touches the sides of the parallelogram in their middles. */
        ELLIPSE;

        /** Whether the point with these coordinates belongs to the piece. */
        boolean holds(double u, double v) {
            return switch (this) {
                case PARALLELOGRAM -> u >= 0 && u <= 1 && v >= 0 && v <= 1;
                case TRIANGLE -> noneIsNegative(u, v, 1 - (u + v));
                case ELLIPSE -> (u - 0.5) * (u - 0.5) + (v - 0.5) * (v - 0.5) <= 0.25;
            };
        }
    }

    /** More than rounding leaves of a coordinate on the piece. */
    private static final double EDGE = 1e-9;

    private final Outline outline;

    // what every ray asks for comes first, so that it lies together in memory
    private final double cornerX;
    private final double cornerY;
    private final double cornerZ;
    private final double normalX;
    private final double normalY;
    private final double normalZ;

    // gradients of u and v
    private final double uX;
    private final double uY;
    private final double uZ;
    private final double vX;
    private final double vY;
    private final double vZ;

    private final double spanUX;
    private final double spanUY;
    private final double spanUZ;
    private final double spanVX;
    private final double spanVY;
    private final double spanVZ;

    /** The piece of the plane at {@code corner} that the vectors U and V span; its front is the side of U x V. */
    public FlatPrimitive(
            Described object, Surface surface, Outline outline, Vector3dc corner, Vector3dc spanU, Vector3dc spanV) {
        this(object, surface, outline, corner, spanU, spanV, Vectors.cross(spanU, spanV));
    }

    /** A piece of which the perpendicular vector {@code normal}, of any length, says where its front is. */
    public FlatPrimitive(
            Described object,
            Surface surface,
            Outline outline,
            Vector3dc corner,
            Vector3dc spanU,
            Vector3dc spanV,
            Vector3dc normal) {
        super(object, surface);
        this.outline = outline;
        Vector3d gradientU = Vectors.cross(spanV, normal);
        Vector3d gradientV = Vectors.cross(normal, spanU);
        gradientU.div(gradientU.dot(spanU));
        gradientV.div(gradientV.dot(spanV));
        Vector3d unit = Vectors.unit(normal);
        cornerX = corner.x();
        cornerY = corner.y();
        cornerZ = corner.z();
        normalX = unit.x;
        normalY = unit.y;
        normalZ = unit.z;
        spanUX = spanU.x();
        spanUY = spanU.y();
        spanUZ = spanU.z();
        spanVX = spanV.x();
        spanVY = spanV.y();
        spanVZ = spanV.z();
        uX = gradientU.x;
        uY = gradientU.y;
        uZ = gradientU.z;
        vX = gradientV.x;
        vY = gradientV.y;
        vZ = gradientV.z;
    }

    @Override
    public double distance(Ray ray, double limit) {
        if (ray.boundary == this) {
            return NO_HIT;
        }
        double toX = cornerX - ray.x;
        double toY = cornerY - ray.y;
        double toZ = cornerZ - ray.z;
        double distance = (normalX * toX + normalY * toY + normalZ * toZ)
                / (normalX * ray.dx + normalY * ray.dy + normalZ * ray.dz);
        if (!(distance > 0 && distance <= limit)) {
            return NO_HIT;
        }
        double offsetX = distance * ray.dx - toX;
        double offsetY = distance * ray.dy - toY;
        double offsetZ = distance * ray.dz - toZ;
        double u = uX * offsetX + uY * offsetY + uZ * offsetZ;
        double v = vX * offsetX + vY * offsetY + vZ * offsetZ;
        return outline.holds(u, v) ? distance : NO_HIT;
    }

    /** By the signs, in one branch: the processor would guess three wrongly. */
    private static boolean noneIsNegative(double first, double second, double third) {
        // a sum of 0 and -0 is 0
        return (Double.doubleToRawLongBits(first + 0.0)
                        | Double.doubleToRawLongBits(second + 0.0)
                        | Double.doubleToRawLongBits(third))
                >= 0;
    }

    @Override
    public Hit hit(Ray ray, double distance, Hit memory) {
        SurfaceCoordinates coordinates = surface().usesCoordinates() ? coordinates(ray, distance) : null;
        return memory.set(ray, distance, normalX, normalY, normalZ, this, 0, coordinates);
    }

    /** The coordinates (u, v) at a distance along a ray. */
    final SurfaceCoordinates coordinates(Ray ray, double distance) {
        double offsetX = ray.x - cornerX + distance * ray.dx;
        double offsetY = ray.y - cornerY + distance * ray.dy;
        double offsetZ = ray.z - cornerZ + distance * ray.dz;
        return new SurfaceCoordinates(
                uX * offsetX + uY * offsetY + uZ * offsetZ,
                vX * offsetX + vY * offsetY + vZ * offsetZ,
                uX,
                uY,
                uZ,
                vX,
                vY,
                vZ);
    }

    /** Whether a ray that meets the piece at a distance meets it at its edge, but for rounding. */
    public boolean isAtEdge(Ray ray, double distance) {
        SurfaceCoordinates at = coordinates(ray, distance);
        return !(outline.holds(at.u() - EDGE, at.v() - EDGE)
                && outline.holds(at.u() - EDGE, at.v() + EDGE)
                && outline.holds(at.u() + EDGE, at.v() - EDGE)
                && outline.holds(at.u() + EDGE, at.v() + EDGE));
    }

    /** Its corners, around the piece; none of an ellipse. */
    public List<Vector3d> corners() {
        Vector3d corner = new Vector3d(cornerX, cornerY, cornerZ);
        Vector3d endU = new Vector3d(spanUX, spanUY, spanUZ).add(corner);
        Vector3d endV = new Vector3d(spanVX, spanVY, spanVZ).add(corner);
        return switch (outline) {
            case PARALLELOGRAM -> List.of(corner, endU, new Vector3d(endU).add(spanVX, spanVY, spanVZ), endV);
            case TRIANGLE -> List.of(corner, endU, endV);
            case ELLIPSE -> List.of();
        };
    }

    @Override
    public List<Vector3d> rim() {
        Vector3d halfU = new Vector3d(spanUX, spanUY, spanUZ).div(2);
        Vector3d halfV = new Vector3d(spanVX, spanVY, spanVZ).div(2);
        return outline == Outline.ELLIPSE
                ? List.of(new Vector3d(cornerX, cornerY, cornerZ).add(halfU).add(halfV), halfU, halfV)
                : List.of();
    }

    @Override
    protected boolean isConvex() {
        return true;
    }

    @Override
    public double minimumAlong(double nx, double ny, double nz) {
        double corner = nx * cornerX + ny * cornerY + nz * cornerZ;
        double alongU = nx * spanUX + ny * spanUY + nz * spanUZ;
        double alongV = nx * spanVX + ny * spanVY + nz * spanVZ;
        if (outline == Outline.ELLIPSE) {
            return corner + (alongU + alongV - Math.sqrt(alongU * alongU + alongV * alongV)) / 2;
        }
        double least = Math.min(0, Math.min(alongU, alongV));
        return corner + (outline == Outline.TRIANGLE ? least : Math.min(least, alongU + alongV));
    }

    /** Exact, and without roots: a mesh has millions. */
    @Override
    public Bounds bounds() {
        return new Bounds(
                least(cornerX, spanUX, spanVX),
                least(cornerY, spanUY, spanVY),
                least(cornerZ, spanUZ, spanVZ),
                -least(-cornerX, -spanUX, -spanVX),
                -least(-cornerY, -spanUY, -spanVY),
                -least(-cornerZ, -spanUZ, -spanVZ));
    }

    /** The least coordinate of the corners. */
    private double least(double corner, double spanU, double spanV) {
        double endU = corner + spanU;
        double least = Math.min(corner, Math.min(endU, corner + spanV));
        return outline == Outline.TRIANGLE ? least : Math.min(least, endU + spanV);
    }
}
