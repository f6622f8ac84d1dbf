package tompkins.sceneobject;

import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.primitive.Placement;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;

/**
 * Objects that move with one velocity. They are described at rest, in a frame of their own, whose origin passes the
 * place at time 0 of the frame around it and with proper time 0; its axes are those of a pure boost.
 */
@Meaning("Objects that move together with a velocity of their own; they are described at rest, in a frame of their own")
public record Moving(
        @Meaning("Name of what moves") String description,

        @Meaning(value = "Velocity in the frame around it", unit = "c")
        Velocity velocity,

        @Meaning(
                value = "Where the origin of the moving frame is at time 0 of the frame around it",
                unit = "length",
                place = true)
        Vector3dc place,

        @Meaning(
                value = "What the clocks in it show when its origin is there; that of a Moving around it is added",
                unit = "time")
        double clockOffset,

        @Meaning("What moves, described at rest") List<SceneObject> objects)
        implements SceneObject {

    /** A ball that passes to the right, in front of the camera. */
    public static final Moving DEFAULT = new Moving(
            "moving",
            Velocity.of(SpeedScale.BETA, 0.5, new Vector3d(1, 0, 0)),
            new Vector3d(),
            0,
            List.of(Sphere.DEFAULT));

    /** The most velocities in a scene, because each has a search of its own. */
    public static final int MOST_FRAMES = 256;

    /** Checks all values. */
    public Moving {
        Velocity.required("velocity", velocity);
        place = Require.finite("place", place);
        Require.finite("clockOffset", clockOffset);
        objects = Require.list("objects", objects);
    }

    @Override
    public double primitiveCount() {
        return objects.stream().mapToDouble(SceneObject::primitiveCount).sum();
    }

    @Override
    public boolean moves() {
        return true;
    }

    @Override
    public void addTo(PrimitiveCollector collector, Placement placement) {
        collector.addMoving(velocity, place, clockOffset, placement, inner -> {
            for (SceneObject object : objects) {
                object.addTo(collector, inner);
            }
        });
    }
}
