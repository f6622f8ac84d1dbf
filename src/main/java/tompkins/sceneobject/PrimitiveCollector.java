package tompkins.sceneobject;

import java.util.ArrayList;
import java.util.List;

/** Collects the primitives of one frame for one picture, and numbers them in the order of the scene file. */
public final class PrimitiveCollector {

    private final List<Primitive> primitives = new ArrayList<>();
    private final ImagePoints imagePoints;

    /**
     * A collector for objects of one frame.
     *
     * @param imagePoints where points in front of the camera are photographed
     */
    public PrimitiveCollector(ImagePoints imagePoints) {
        this.imagePoints = imagePoints;
    }

    /** Collects objects whose place does not depend on the camera; image points stay where they are. */
    public static List<Primitive> primitivesOf(SceneObject object) {
        PrimitiveCollector collector = new PrimitiveCollector(point -> point);
        object.addTo(collector, Placement.NONE);
        return collector.primitives();
    }

    /** Adds one primitive behind those that are there. */
    public void add(Primitive primitive) {
        primitive.setOrder(primitives.size());
        primitives.add(primitive);
    }

    /** Where points in front of the camera are photographed. */
    public ImagePoints imagePoints() {
        return imagePoints;
    }

    /** How many primitives there are so far. */
    public int size() {
        return primitives.size();
    }

    /** All primitives so far. */
    public List<Primitive> primitives() {
        return List.copyOf(primitives);
    }
}
