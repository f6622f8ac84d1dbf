package tompkins.spacetime;

import org.joml.Vector3d;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.SurfaceCoordinates;

/**
 * The inertial frame in which the point that is hit rests for a moment, on an object that turns: that of a pure boost
 * with its velocity V. Place and time of the hit are the same in it, by a choice of its coordinates. Surfaces answer
 * light there.
 */
public final class MomentaryRestFrame {

    private final Velocity velocity;
    private final boolean isLorentz;
    private final SpaceTimeTransformation into;
    private final Hit hit;
    private double stretch = 1;

    /** The frame of a hit on something that turns, which must stay as it is but for what {@link #enter} sets. */
    public MomentaryRestFrame(Hit hit, TransformationLaw law) {
        this.hit = hit;
        velocity = Velocity.of(hit.velocityX, hit.velocityY, hit.velocityZ);
        isLorentz = law == TransformationLaw.LORENTZ;
        into = law.sceneFromCamera(velocity).inverse();
    }

    /** The ray of the hit in this frame. */
    public Ray enter(Ray ray) {
        Ray inside = transform(ray, into);
        stretch = inside.directionLength / ray.directionLength;
        return inside;
    }

    private Ray transform(Ray ray, SpaceTimeTransformation transformation) {
        Ray moved = Ray.blank().set(ray).move(-hit.x, -hit.y, -hit.z, -hit.time);
        return transformation.transform(moved, moved).move(hit.x, hit.y, hit.z, hit.time);
    }

    /**
     * Gives the hit the normal, the coordinates and the distance of this frame, after its ray. A gradient g becomes
     * {@code g - u (u.g)/(gamma (gamma + 1))}.
     */
    public void enterHit() {
        hit.stretch(stretch);
        if (isLorentz) {
            Vector3d normal = normal();
            hit.shade(normal.x, normal.y, normal.z);
            SurfaceCoordinates at = hit.coordinates;
            if (at != null) {
                hit.locate(new SurfaceCoordinates(
                        at.u(), at.v(), gradient(at.uX(), at.uY(), at.uZ()), gradient(at.vX(), at.vY(), at.vZ())));
            }
        }
    }

    /** The unit normal of the hit in this frame, before that is given to the hit. */
    public Vector3d normal() {
        Vector3d normal = new Vector3d(hit.normalX, hit.normalY, hit.normalZ);
        return isLorentz ? gradient(normal.x, normal.y, normal.z).normalize() : normal;
    }

    private Vector3d gradient(double x, double y, double z) {
        double along = velocity.proper().dot(x, y, z);
        double gamma = velocity.gamma();
        return new Vector3d(x, y, z).fma(-along / (gamma * (gamma + 1)), velocity.proper());
    }

    /** A ray that goes on from the hit, back in the frame in which the object turns. */
    public Ray leave(Ray ray) {
        Ray outside = transform(ray, into.inverse());
        outside.setStart(hit);
        return outside;
    }

    /** A direction of light that starts at the hit, which the ray holds, in this frame. */
    public void turn(Ray ray) {
        into.transform(ray, ray);
    }
}
