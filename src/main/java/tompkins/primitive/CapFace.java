package tompkins.primitive;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/** A spherical cap, as {@link CapPrimitive} describes it. */
final class CapFace extends Face {

    private final Vector3dc vertex;
    private final Vector3dc axis;
    private final double radius;
    private final double curvature;

    /**
     * A cap.
     *
     * @param vertex its middle, relative to the centre of the rotation
     * @param axis unit vector, outwards
     */
    CapFace(Vector3dc vertex, Vector3dc axis, double radius, double curvature) {
        super(0);
        this.vertex = vertex;
        this.axis = axis;
        this.radius = radius;
        this.curvature = curvature;
    }

    private Vector3d place(TurningPath path) {
        return new Vector3d(path.x, path.y, path.z).sub(vertex);
    }

    @Override
    double value(TurningPath path) {
        Vector3d place = place(path);
        return curvature * place.lengthSquared() + 2 * axis.dot(place);
    }

    @Override
    double slope(TurningPath path) {
        return 2 * place(path).mul(curvature).add(axis).dot(path.vx, path.vy, path.vz);
    }

    @Override
    double bend(TurningPath path, double reach) {
        return 2 * (Math.abs(curvature) * path.speed * path.speed + path.bend * steepness(path));
    }

    @Override
    double error(TurningPath path) {
        return 4 * path.rounding * steepness(path);
    }

    /** Half the most by which the function changes with the place. */
    private double steepness(TurningPath path) {
        return 1 + Math.abs(curvature) * (path.farthest + vertex.length());
    }

    @Override
    boolean holds(TurningPath path) {
        Vector3d place = place(path);
        return CapPrimitive.holds(place.x, place.y, place.z, axis, radius, curvature);
    }
}
