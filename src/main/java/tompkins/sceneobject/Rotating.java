package tompkins.sceneobject;

import java.util.List;
import org.joml.Matrix3d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;
import tompkins.primitive.Placement;
import tompkins.primitive.Primitive;
import tompkins.primitive.Rotation;
import tompkins.property.InvalidPropertyException;
import tompkins.property.Meaning;
import tompkins.property.NumberText;
import tompkins.property.Require;
import tompkins.spacetime.FrameTree;
import tompkins.spacetime.TransformationLaw;
import tompkins.surface.ColouredSurface;

/**
 * Objects that turn about an axis, which rests in the frame around them. Each point of them runs on a circle with a
 * constant speed below 1. That is a motion, and not a rigid body: lengths along the circles are those in the frame of
 * the axis, and nothing says how the turning began.
 */
@Meaning("Objects that turn about an axis at rest in the frame around them; they are described at the angle 0")
public record Rotating(
        @Meaning("Name of what turns") String description,

        @Meaning(value = "A point of the axis", unit = "length", place = true)
        Vector3dc centre,

        @Meaning("Direction of the axis, of any length") Vector3dc axis,

        @Meaning(
                value = "How fast it turns; times the distance from the axis it is a speed, which must stay below 1."
                        + " About z, above 0 takes x to y",
                unit = "radians per time")
        double angularSpeed,

        @Meaning(value = "The angle at time 0; about z, 90 degrees take x to y", unit = "degrees")
        double phaseDegrees,

        @Meaning("What turns: objects that are bounded and at rest, without glass and windows")
        List<SceneObject> objects)
        implements SceneObject {

    /** A rod that turns like a propeller, in front of the camera. */
    public static final Rotating DEFAULT = new Rotating(
            "rotating",
            new Vector3d(0, 0, 10),
            new Vector3d(0, 0, 1),
            0.5,
            0,
            List.of(new Cylinder(
                    "rod", new Vector3d(-1, 0, 10), new Vector3d(1, 0, 10), 0.1, true, ColouredSurface.DEFAULT)));

    private static final String OBJECTS = "objects";

    /** Checks all values, and that every point is slower than light. */
    public Rotating {
        centre = Require.position("centre", centre);
        axis = Require.direction("axis", axis);
        Require.finite("angularSpeed", angularSpeed);
        Require.finite("phaseDegrees", phaseDegrees);
        objects = Require.list(OBJECTS, objects);
        for (SceneObject object : objects) {
            if (object.moves()) {
                throw refusal(object, "at rest, without Moving or Rotating in it");
            }
            // more than that are refused when the whole scene is counted
            if (object.primitiveCount() <= MOST_PRIMITIVES) {
                requireSlow(object, new Rotation(centre, Vectors.unit(axis), angularSpeed, 0, 0, true), angularSpeed);
            }
        }
    }

    private static InvalidPropertyException refusal(SceneObject object, String allowed) {
        return new InvalidPropertyException(OBJECTS, allowed, '"' + object.description() + '"');
    }

    private static void requireSlow(SceneObject object, Rotation rotation, double angularSpeed) {
        for (Primitive primitive : primitives(object)) {
            if (primitive.bounds() == null) {
                throw refusal(object, "bounded, without a Plane in it");
            }
            if (!primitive.surface().canTurn()) {
                throw refusal(object, "without glass and windows");
            }
            double reach = rotation.reach(primitive);
            if (!(Math.abs(angularSpeed) * reach < 1)) {
                throw new InvalidPropertyException(
                        "angularSpeed",
                        "so slow that every point of \"" + object.description()
                                + "\" stays slower than light: below "
                                + NumberText.of(NumberText.rounded(1 / reach, 6)) + " for the distance "
                                + NumberText.of(NumberText.rounded(reach, 6)) + " from the axis",
                        angularSpeed);
            }
        }
    }

    /** The primitives of an object as it is described; image points have no place of their own. */
    private static List<Primitive> primitives(SceneObject object) {
        PrimitiveCollector collector = new PrimitiveCollector(
                point -> {
                    throw refusal(object, "without ImagePointGrid in it, which the camera places");
                },
                FrameTree.described(TransformationLaw.NONE));
        try {
            object.addTo(collector, Placement.NONE);
            return collector.primitives(0);
        } catch (ArithmeticException beyondNumbers) {
            throw PrimitiveCollector.refusal(OBJECTS, '"' + object.description() + '"');
        }
    }

    @Override
    public double primitiveCount() {
        return objects.stream().mapToDouble(SceneObject::primitiveCount).sum();
    }

    @Override
    public boolean moves() {
        return angularSpeed != 0;
    }

    /** What turns goes along with its axis. */
    @Override
    public Rotating shifted(Vector3dc shift) {
        List<SceneObject> content =
                new Group(description, objects).shifted(shift).objects();
        return new Rotating(description, Vectors.writtenSum(centre, shift), axis, angularSpeed, phaseDegrees, content);
    }

    @Override
    public void addTo(PrimitiveCollector collector, Placement placement) {
        // without a law nothing is seen to turn
        if (!moves() || collector.law() == TransformationLaw.NONE) {
            Matrix3d turn = new Matrix3d().rotation(Math.toRadians(phaseDegrees), Vectors.unit(axis));
            Vector3d translation = centre.sub(turn.transform(centre, new Vector3d()), new Vector3d());
            Placement turned = placement.after(new Placement(1, turn, translation));
            objects.forEach(object -> object.addTo(collector, turned));
            return;
        }
        Rotation rotation = new Rotation(
                placement.point(centre),
                placement.direction(Vectors.unit(axis)),
                angularSpeed / placement.scale(),
                phaseDegrees,
                collector.zeroTime(),
                collector.law() == TransformationLaw.LORENTZ);
        collector.addTurning(rotation, () -> objects.forEach(object -> object.addTo(collector, placement)));
    }
}
