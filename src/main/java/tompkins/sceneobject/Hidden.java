package tompkins.sceneobject;

import org.joml.Vector3dc;
import tompkins.primitive.Placement;
import tompkins.property.Meaning;

/** An object that is kept in the scene file but left out of the picture. */
@Meaning("An object that is kept in the scene file but left out of the picture")
public record Hidden(@Meaning("The object") SceneObject object) implements SceneObject {

    /** A hidden sphere. */
    public static final Hidden DEFAULT = new Hidden(Sphere.DEFAULT);

    @Override
    public String description() {
        return object.description();
    }

    @Override
    public double primitiveCount() {
        return 0;
    }

    @Override
    public Hidden shifted(Vector3dc shift) {
        return new Hidden(object.shifted(shift));
    }

    @Override
    public void addTo(PrimitiveCollector collector, Placement placement) {
        // hidden: nothing
    }
}
