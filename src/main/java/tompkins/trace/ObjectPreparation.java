package tompkins.trace;

import java.util.List;
import tompkins.property.InvalidPropertyException;
import tompkins.property.NumberText;
import tompkins.sceneobject.Bounds;
import tompkins.sceneobject.Placement;
import tompkins.sceneobject.Primitive;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.sceneobject.SceneObject;

/** Makes primitives of objects; refuses too many, and those of such sizes that what is worked out from them is no number. */
final class ObjectPreparation {

    /** The sizes that always work: their fourth powers are far from the limits of a double. Others may work, too. */
    private static final String ALLOWED = "of a size that can be worked with (lengths from 1e-50 to 1e50 always can)";

    private ObjectPreparation() {}

    /**
     * Adds the primitives of a list of objects.
     *
     * @param name what scene files call the list
     * @throws InvalidPropertyException if an object is too large or too small to work with, or there are too many
     */
    static void add(String name, List<SceneObject> objects, PrimitiveCollector collector, Placement placement) {
        requireFewEnough(name, objects);
        int[] starts = new int[objects.size() + 1];
        for (int i = 0; i < objects.size(); i++) {
            starts[i] = collector.size();
            try {
                objects.get(i).addTo(collector, placement);
            } catch (ArithmeticException | InvalidPropertyException beyondNumbers) {
                throw refusal(name, i, objects.get(i));
            }
        }
        starts[objects.size()] = collector.size();
        List<Primitive> primitives = collector.primitives();
        for (int i = 0; i < objects.size(); i++) {
            if (!primitives.subList(starts[i], starts[i + 1]).stream().allMatch(ObjectPreparation::isUsable)) {
                throw refusal(name, i, objects.get(i));
            }
        }
    }

    /** Counts before anything is made: copies of copies would take for ever. */
    private static void requireFewEnough(String name, List<SceneObject> objects) {
        double before = 0;
        for (int i = 0; i < objects.size(); i++) {
            double count = objects.get(i).primitiveCount();
            if (before + count > SceneObject.MOST_PRIMITIVES) {
                throw new InvalidPropertyException(
                        place(name, i),
                        "small enough for at most " + NumberText.of(SceneObject.MOST_PRIMITIVES) + " primitives in all",
                        quoted(objects.get(i)) + " with " + NumberText.of(count)
                                + (before == 0 ? "" : " (after " + NumberText.of(before) + ")"));
            }
            before += count;
        }
    }

    /** Whether the size of a primitive is a number; planes have none. */
    private static boolean isUsable(Primitive primitive) {
        Bounds bounds = primitive.bounds();
        return bounds == null || Double.isFinite(bounds.halfArea());
    }

    private static InvalidPropertyException refusal(String name, int index, SceneObject object) {
        return new InvalidPropertyException(place(name, index), ALLOWED, quoted(object));
    }

    private static String place(String name, int index) {
        return name + "[" + index + "]";
    }

    private static String quoted(SceneObject object) {
        return '"' + object.description() + '"';
    }

    /** The refusal of a scene whose objects and lamps are too far apart. */
    static InvalidPropertyException refusal(String name) {
        return new InvalidPropertyException(name, ALLOWED, "larger");
    }
}
