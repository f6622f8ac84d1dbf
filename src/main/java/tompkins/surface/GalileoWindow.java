package tompkins.surface;

import org.joml.Vector3dc;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.spacetime.Velocity;

/**
 * A sheet that changes the direction of light as a Galilean change of frame does: the traced direction n becomes n +
 * beta, in a medium n plus the slowness times beta (Oxburgh et al. 2014). In front of a camera with a Galilean
 * transformation of the same velocity it undoes the aberration.
 */
@Meaning("A sheet that changes the direction of light as a Galilean change of frame does")
public record GalileoWindow(
        @Meaning(value = "Velocity of the change of frame", unit = "c")
        Velocity velocity,

        @Meaning("The axes in which the velocity is given: those of the frame, or u, v and the normal of the surface")
        WindowAxes axes,

        @Meaning("Share of the light that passes, from 0 to 1")
        double transmission)
        implements FrameWindow {

    /** A sheet that changes nothing and dims a little. */
    public static final GalileoWindow DEFAULT = new GalileoWindow(Velocity.REST, WindowAxes.FRAME, 0.96);

    /** Checks all values. */
    public GalileoWindow {
        Velocity.required("velocity", velocity);
        Require.within("transmission", transmission, 0.0, 1.0);
    }

    @Override
    public Response respond(Ray ray, Hit hit, Tracer tracer) {
        Vector3dc beta = axes.inFrame(velocity.components(), hit);
        double slowness = ray.lightSlowness();
        double dx = ray.dx + beta.x() * slowness;
        double dy = ray.dy + beta.y() * slowness;
        double dz = ray.dz + beta.z() * slowness;
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        if (length == 0) {
            return Response.ends(Colour.BLACK);
        }
        Ray next = ray.bent(hit, dx / length, dy / length, dz / length, transmission)
                .slowed(slowness / length)
                .narrowed(length)
                .behindWindow(length);
        return Response.goesOn(next, Colour.grey(transmission));
    }
}
