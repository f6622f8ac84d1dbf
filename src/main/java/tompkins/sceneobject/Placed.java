package tompkins.sceneobject;

import org.joml.AxisAngle4d;
import org.joml.Matrix3d;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.RigidMotion;
import tompkins.math.Vectors;
import tompkins.primitive.Placement;
import tompkins.property.Meaning;
import tompkins.property.Require;

/**
 * An object that is scaled about the origin, then rotated about an axis through the origin, then moved. The sense of
 * rotation: an observer towards whom the axis points sees a turn from x to y about z as clockwise (axes are
 * left-handed).
 */
@Meaning("An object that is scaled about the origin, then rotated about an axis through the origin, then moved")
public record Placed(
        @Meaning("Name of the object") String description,
        @Meaning("The object") SceneObject object,
        @Meaning("Factor of all lengths, above 0") double scale,
        @Meaning("Axis of the rotation, of any length") Vector3dc rotationAxis,

        @Meaning(value = "Angle of the rotation; about z, 90 degrees take x to y", unit = "degrees")
        double rotationDegrees,

        @Meaning(value = "By how much the object is moved", unit = "length", place = true)
        Vector3dc translation)
        implements SceneObject {

    /** A sphere where it is. */
    public static final Placed DEFAULT =
            new Placed("placed", Sphere.DEFAULT, 1, new Vector3d(0, 1, 0), 0, new Vector3d());

    /** Checks all values. */
    public Placed {
        Require.positive("scale", scale);
        rotationAxis = Require.direction("rotationAxis", rotationAxis);
        Require.finite("rotationDegrees", rotationDegrees);
        translation = Require.finite("translation", translation);
    }

    @Override
    public double primitiveCount() {
        return object.primitiveCount();
    }

    @Override
    public boolean moves() {
        return object.moves();
    }

    @Override
    public void addTo(PrimitiveCollector collector, Placement placement) {
        object.addTo(collector, placement.after(placement()));
    }

    /** How the object is placed. */
    public Placement placement() {
        Matrix3d rotation = new Matrix3d().rotation(Math.toRadians(rotationDegrees), Vectors.unit(rotationAxis));
        return new Placement(scale, rotation, translation);
    }

    /** Both motions become one, so that an object that is moved again and again does not grow. */
    @Override
    public Placed moved(RigidMotion motion) {
        Vector3d axis = Vectors.unit(rotationAxis);
        Quaterniond before = new Quaterniond().fromAxisAngleRad(axis, Math.toRadians(rotationDegrees));
        AxisAngle4d turn =
                new AxisAngle4d(motion.rotation().mul(before, new Quaterniond()).normalize());
        boolean turns = turn.angle != 0;
        return new Placed(
                description,
                object,
                scale,
                turns ? new Vector3d(turn.x, turn.y, turn.z) : axis,
                Math.toDegrees(turn.angle),
                motion.place(translation));
    }
}
