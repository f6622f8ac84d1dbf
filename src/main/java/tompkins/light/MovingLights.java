package tompkins.light;

import java.util.List;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.property.TypeName;
import tompkins.ray.Colour;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;

/** Light sources that move with one velocity. They are described at rest in a frame of their own, as moving objects. */
@TypeName("Moving")
@Meaning(
        "Light sources that move together with a velocity of their own; they are described at rest, like moving objects")
public record MovingLights(
        @Meaning(value = "Velocity in the frame around it", unit = "c")
        Velocity velocity,

        @Meaning(value = "Where the origin of the moving frame is at time 0 of the frame around it", unit = "length")
        Vector3dc place,

        @Meaning("The light sources, described at rest") List<LightSource> objects)
        implements LightSource {

    /** A lamp that passes to the right, above what is in front of the camera. */
    public static final MovingLights DEFAULT = new MovingLights(
            Velocity.of(SpeedScale.BETA, 0.5, new Vector3d(1, 0, 0)),
            new Vector3d(),
            List.of(new PointLight(new Vector3d(0, 4, 8), Colour.WHITE, Colour.WHITE, 40)));

    /** Checks all values. */
    public MovingLights {
        Velocity.required("velocity", velocity);
        place = Require.finite("place", place);
        objects = Require.list("objects", objects);
    }

    @Override
    public Stream<RestingLight> atRest() {
        return objects.stream().flatMap(LightSource::atRest).map(light -> light.shifted(place));
    }
}
