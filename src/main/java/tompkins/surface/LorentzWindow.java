package tompkins.surface;

import org.joml.Vector3d;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.spacetime.LorentzTransformation;
import tompkins.spacetime.Velocity;

/**
 * A sheet that changes the direction of light as a change of frame does (Oxburgh et al. 2014). In front of the lens of
 * a camera that moves with the same velocity it undoes the camera's aberration: the traced direction becomes the
 * spatial part of the inverse transformation, {@code d + u ((u.d)/(gamma + 1) + |d|)}. The window itself is at rest: it
 * changes neither the place, nor the time, nor the frequency of the light.
 */
@Meaning("A sheet that changes the direction of light as a change of frame does, and so can undo the aberration")
public record LorentzWindow(
        @Meaning(
                value = "Velocity of the change of frame; that of the camera undoes the camera's aberration",
                unit = "c")
        Velocity velocity,

        @Meaning("The axes in which the velocity is given: those of the frame, or u, v and the normal of the surface")
        WindowAxes axes,

        @Meaning("Share of the light that passes, from 0 to 1")
        double transmission)
        implements FrameWindow {

    /** A sheet that changes nothing and dims a little. */
    public static final LorentzWindow DEFAULT = new LorentzWindow(Velocity.REST, WindowAxes.FRAME, 0.96);

    /** Checks all values. */
    public LorentzWindow {
        Velocity.required("velocity", velocity);
        Require.within("transmission", transmission, 0.0, 1.0);
    }

    @Override
    public Response respond(Ray ray, Hit hit, Tracer tracer) {
        Ray next = velocity.isRest() ? ray.straightOn(hit, transmission) : turned(ray, hit);
        return Response.goesOn(next, Colour.grey(transmission));
    }

    private Ray turned(Ray ray, Hit hit) {
        Vector3d direction = new Vector3d(ray.dx, ray.dy, ray.dz);
        Vector3d back = axes.inFrame(velocity.direction(), hit).negate(new Vector3d());
        double directionLength = LorentzTransformation.turn(velocity, back, direction);
        return ray.bent(hit, direction.x, direction.y, direction.z, transmission)
                .narrowed(directionLength)
                .behindWindow(directionLength);
    }
}
