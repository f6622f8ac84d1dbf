package tompkins.primitive;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;

/** A flat face: the height over its plane, and coordinates that say what belongs to it. */
final class FlatFace extends Face {

    private final FlatPrimitive.Outline outline;
    private final Vector3dc corner;
    private final Vector3dc normal;
    private final Vector3dc gradientU;
    private final Vector3dc gradientV;

    /** The piece at a corner, relative to the centre of the rotation, that two vectors span. */
    FlatFace(int part, FlatPrimitive.Outline outline, Vector3dc corner, Vector3dc spanU, Vector3dc spanV) {
        super(part);
        this.outline = outline;
        this.corner = corner;
        Vector3d across = Vectors.cross(spanU, spanV);
        Vector3d u = Vectors.cross(spanV, across);
        Vector3d v = Vectors.cross(across, spanU);
        gradientU = u.div(u.dot(spanU));
        gradientV = v.div(v.dot(spanV));
        normal = Vectors.unit(across);
    }

    /** The disc around a middle, relative to that centre. */
    static FlatFace disc(int part, Vector3dc middle, Vector3dc normal, double radius) {
        Vector3d right = Vectors.firstAxis(normal);
        Vector3d up = normal.cross(right, new Vector3d());
        Vector3d corner = middle.fma(-radius, right, new Vector3d()).fma(-radius, up);
        return new FlatFace(part, FlatPrimitive.Outline.ELLIPSE, corner, right.mul(2 * radius), up.mul(2 * radius));
    }

    @Override
    double value(TurningPath path) {
        return along(path, normal);
    }

    private double along(TurningPath path, Vector3dc direction) {
        return (path.x - corner.x()) * direction.x()
                + (path.y - corner.y()) * direction.y()
                + (path.z - corner.z()) * direction.z();
    }

    @Override
    double slope(TurningPath path) {
        return normal.x() * path.vx + normal.y() * path.vy + normal.z() * path.vz;
    }

    @Override
    double bend(TurningPath path, double reach) {
        return path.bendAlong(normal);
    }

    @Override
    double error(TurningPath path) {
        return 2 * path.rounding;
    }

    @Override
    boolean holds(TurningPath path) {
        return outline.holds(along(path, gradientU), along(path, gradientV));
    }
}
