package tompkins.sceneobject;

import java.util.List;
import org.joml.Vector3dc;
import tompkins.primitive.Placement;
import tompkins.property.Meaning;
import tompkins.property.Require;

/** Several objects under one name. */
@Meaning("Several objects under one name")
public record Group(
        @Meaning("Name of the group") String description,
        @Meaning("The objects") List<SceneObject> objects) implements SceneObject {

    /** Empty. */
    public static final Group DEFAULT = new Group("group", List.of());

    /** Checks that no object is missing. */
    public Group {
        objects = Require.list("objects", objects);
    }

    @Override
    public double primitiveCount() {
        return objects.stream().mapToDouble(SceneObject::primitiveCount).sum();
    }

    @Override
    public boolean moves() {
        return objects.stream().anyMatch(SceneObject::moves);
    }

    @Override
    public Group shifted(Vector3dc shift) {
        return new Group(
                description,
                objects.stream().map(object -> object.shifted(shift)).toList());
    }

    @Override
    public void addTo(PrimitiveCollector collector, Placement placement) {
        objects.forEach(object -> object.addTo(collector, placement));
    }
}
