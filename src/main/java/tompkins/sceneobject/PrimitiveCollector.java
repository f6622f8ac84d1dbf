package tompkins.sceneobject;

import java.util.ArrayList;
import java.util.List;
import tompkins.primitive.Bounds;
import tompkins.primitive.Placement;
import tompkins.primitive.Primitive;
import tompkins.property.InvalidPropertyException;

/** Collects the primitives of one frame for one picture, and numbers them in the order of the scene file. */
public final class PrimitiveCollector {

    /** The sizes that always work: their fourth powers are far from the limits of a double. Others may work, too. */
    private static final String ALLOWED = "of a size that can be worked with (lengths from 1e-50 to 1e50 always can)";

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

    /** The refusal of something that is so large, small or far away that what is worked out from it is no number. */
    public static InvalidPropertyException refusal(String property, String value) {
        return new InvalidPropertyException(property, ALLOWED, value);
    }

    /**
     * Adds the primitives of an object.
     *
     * @param property what scene files call the place of the object
     * @throws InvalidPropertyException if the object is too large or too small to work with
     */
    public void add(String property, SceneObject object, Placement placement) {
        int first = primitives.size();
        try {
            object.addTo(this, placement);
            primitives.subList(first, primitives.size()).forEach(PrimitiveCollector::requireSize);
        } catch (ArithmeticException | InvalidPropertyException beyondNumbers) {
            InvalidPropertyException refusal = refusal(property, '"' + object.description() + '"');
            refusal.initCause(beyondNumbers);
            throw refusal;
        }
    }

    /** Accepts what has a size that is a number, or none, as planes. */
    private static void requireSize(Primitive primitive) {
        Bounds bounds = primitive.bounds();
        if (bounds != null && !Double.isFinite(bounds.halfArea())) {
            throw new ArithmeticException("no size: " + bounds);
        }
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

    /** All primitives so far. */
    public List<Primitive> primitives() {
        return List.copyOf(primitives);
    }
}
