package tompkins.world;

import java.util.List;
import tompkins.primitive.Placement;
import tompkins.property.InvalidPropertyException;
import tompkins.property.NumberText;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.sceneobject.SceneObject;

/** Makes primitives from lists of objects, if there are not too many. */
public final class ObjectPreparation {

    private ObjectPreparation() {}

    /**
     * Adds the primitives of a list of objects.
     *
     * @param name what scene files call the list
     * @throws InvalidPropertyException if an object is too large or too small to work with, or there are too many
     */
    public static void add(String name, List<SceneObject> objects, PrimitiveCollector collector, Placement placement) {
        requireFewEnough(name, objects);
        for (int i = 0; i < objects.size(); i++) {
            collector.add(place(name, i), objects.get(i), placement);
        }
    }

    /** Counts before anything is made, because copies of copies could take forever. */
    private static void requireFewEnough(String name, List<SceneObject> objects) {
        double before = 0;
        for (int i = 0; i < objects.size(); i++) {
            SceneObject object = objects.get(i);
            double count = object.primitiveCount();
            if (before + count > SceneObject.MOST_PRIMITIVES) {
                throw new InvalidPropertyException(
                        place(name, i),
                        "small enough for at most " + NumberText.of(SceneObject.MOST_PRIMITIVES) + " primitives in all",
                        '"' + object.description() + "\" with " + NumberText.of(count)
                                + (before == 0 ? "" : " (after " + NumberText.of(before) + ")"));
            }
            before += count;
        }
    }

    private static String place(String name, int index) {
        return name + "[" + index + "]";
    }
}
