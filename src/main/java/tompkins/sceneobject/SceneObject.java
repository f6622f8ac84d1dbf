package tompkins.sceneobject;

import java.util.List;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.RigidMotion;
import tompkins.math.Vectors;
import tompkins.primitive.Described;
import tompkins.primitive.Placement;
import tompkins.property.Descriptions;
import tompkins.property.InvalidPropertyException;

/** Something in the scene: a shape, or several of them. Descriptions, immutable, checked when they are made. */
public sealed interface SceneObject extends Described
        permits Sphere,
                Ellipsoid,
                Plane,
                Disc,
                Parallelogram,
                Triangle,
                TriangleMesh,
                Box,
                Cylinder,
                Cone,
                Lens,
                CylinderLattice,
                Silhouette,
                Group,
                Placed,
                Moving,
                Rotating,
                ImagePointGrid,
                Hidden,
                AddedObject {

    /** The most primitives of a picture, so that copies of copies neither fill the memory nor take all day. */
    double MOST_PRIMITIVES = 10_000_000;

    /**
     * The number of primitives that the object becomes, or a few more; a double, because copies of copies may be too
     * many for a whole number.
     */
    default double primitiveCount() {
        return 1;
    }

    /**
     * Accepts an object only if nothing in it moves.
     *
     * @throws InvalidPropertyException if something in it moves
     */
    static SceneObject requireAtRest(String property, SceneObject object) {
        if (object.moves()) {
            throw new InvalidPropertyException(
                    property,
                    "at rest with the camera, without Moving or Rotating in it",
                    '"' + object.description() + "\", which moves");
        }
        return object;
    }

    /** Whether something in it moves in the frame of the object. */
    default boolean moves() {
        return false;
    }

    /** Adds the primitives of this object, placed, in the order in which they are listed. */
    void addTo(PrimitiveCollector collector, Placement placement);

    /** The same object after a motion: a {@link Placed} one, unless its kind has another way to say where it is. */
    default SceneObject moved(RigidMotion motion) {
        return new Placed(description(), this, 1, new Vector3d(0, 1, 0), 0, new Vector3d()).moved(motion);
    }

    /**
     * The same object elsewhere: all its places change by a vector, added as people write numbers. What has no place of
     * its own is {@link Placed}.
     */
    default SceneObject shifted(Vector3dc shift) {
        List<String> places = Descriptions.places(getClass());
        return places.isEmpty()
                ? moved(new RigidMotion(new Quaterniond(), shift))
                : Descriptions.changed(
                        this,
                        (name, value) -> places.contains(name) ? Vectors.writtenSum((Vector3dc) value, shift) : value);
    }
}
