package tompkins.primitive;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.ray.Hit;
import tompkins.ray.MeshDetail;
import tompkins.ray.Ray;
import tompkins.ray.SurfaceCoordinates;
import tompkins.surface.Continuation;
import tompkins.surface.Surface;

/**
 * A flat triangle of a mesh that has coordinates of its own, or normals at its corners: between these both change
 * linearly (B. T. Phong, "Illumination for computer generated pictures", 1975). Where a normal would turn a side that
 * is seen away from the viewer, the triangle is shown as flat as it is.
 */
public final class ShadedTriangle extends FlatPrimitive {

    private final MeshDetail detail;
    private final int triangle;
    private final Placement placement;

    /** The triangle with a number in a mesh, at a corner and with the spans to the other two corners. */
    public ShadedTriangle(
            Described object,
            Surface surface,
            Vector3dc corner,
            Vector3dc spanU,
            Vector3dc spanV,
            MeshDetail detail,
            int triangle,
            Placement placement) {
        super(object, surface, Outline.TRIANGLE, corner, spanU, spanV);
        this.detail = detail;
        this.triangle = triangle;
        this.placement = placement;
    }

    @Override
    public Hit hit(Ray ray, double distance, Hit memory) {
        super.hit(ray, distance, memory);
        SurfaceCoordinates flat = coordinates(ray, distance);
        if (detail.hasTexture(triangle) && surface().usesCoordinates()) {
            memory.locate(textured(flat));
        }
        // light that goes on keeps to the triangle itself
        if (detail.hasNormals(triangle) && surface().continuation() == Continuation.NONE) {
            smooth(flat, ray, memory);
        }
        return memory;
    }

    private SurfaceCoordinates textured(SurfaceCoordinates flat) {
        double u0 = detail.texture(triangle, 0, 0);
        double uAlongU = detail.texture(triangle, 1, 0) - u0;
        double uAlongV = detail.texture(triangle, 2, 0) - u0;
        double v0 = detail.texture(triangle, 0, 1);
        double vAlongU = detail.texture(triangle, 1, 1) - v0;
        double vAlongV = detail.texture(triangle, 2, 1) - v0;
        return new SurfaceCoordinates(
                u0 + flat.u() * uAlongU + flat.v() * uAlongV,
                v0 + flat.u() * vAlongU + flat.v() * vAlongV,
                flat.uX() * uAlongU + flat.vX() * uAlongV,
                flat.uY() * uAlongU + flat.vY() * uAlongV,
                flat.uZ() * uAlongU + flat.vZ() * uAlongV,
                flat.uX() * vAlongU + flat.vX() * vAlongV,
                flat.uY() * vAlongU + flat.vY() * vAlongV,
                flat.uZ() * vAlongU + flat.vZ() * vAlongV);
    }

    private void smooth(SurfaceCoordinates flat, Ray ray, Hit hit) {
        Vector3d normal = normal(flat).normalize();
        double seen = normal.x * ray.dx + normal.y * ray.dy + normal.z * ray.dz;
        if (seen * hit.cosine(ray) > 0) {
            hit.shade(normal.x, normal.y, normal.z);
        }
    }

    /** The normal between the corners, of any length. */
    private Vector3d normal(SurfaceCoordinates flat) {
        double first = 1 - flat.u() - flat.v();
        Vector3d sum = new Vector3d();
        for (int axis = 0; axis < 3; axis++) {
            sum.setComponent(
                    axis,
                    first * detail.normal(triangle, 0, axis)
                            + flat.u() * detail.normal(triangle, 1, axis)
                            + flat.v() * detail.normal(triangle, 2, axis));
        }
        return placement.direction(sum);
    }

    /**
     * Where light ends, a triangle looks away from a lamp that its normals see, and its light would come through the
     * inside of the mesh. What it leaves through the back is no obstacle to the smooth surface, and throws no shadow.
     */
    @Override
    public boolean shadows(Ray ray, double limit) {
        return super.shadows(ray, limit)
                && !(ray.boundary instanceof ShadedTriangle start
                        && start.detail == detail
                        && start.placement == placement
                        && start.outwards(ray, 0) < 0
                        && start.normal(start.coordinates(ray, 0)).dot(ray.dx, ray.dy, ray.dz) > 0
                        && outwards(ray, distance(ray, limit)) > 0);
    }

    /** How far a ray runs to the side of the flat triangle to which its normals point; 0 if it has none. */
    private double outwards(Ray ray, double distance) {
        if (!detail.hasNormals(triangle)) {
            return 0;
        }
        Hit flat = super.hit(ray, distance, Hit.blank());
        Vector3d normal = normal(coordinates(ray, distance));
        return Math.signum(normal.dot(flat.normalX, flat.normalY, flat.normalZ)) * flat.cosine(ray);
    }
}
