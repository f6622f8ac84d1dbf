package tompkins.trace;

import java.util.List;
import java.util.Objects;
import org.joml.Matrix3d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.light.LightSource;
import tompkins.primitive.Placement;
import tompkins.sceneobject.ImagePoints;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.sceneobject.SceneObject;
import tompkins.search.LampShadows;
import tompkins.search.ObjectTree;
import tompkins.studio.Studio;

/**
 * The scene, ready to be met by rays: its primitives in a tree, its lamps, and what each lamp sees. Nothing of it
 * depends on the camera, unless the scene holds image points; a film in which only the camera changes uses one for all
 * its pictures.
 */
final class PreparedScene {

    /** The lamps that get a grid, which takes milliseconds to make; with more of them the tree does for the rest. */
    private static final int MOST_GRIDS = 16;

    /** Primitives that all lamps with grids see: a million take 30 MB and half a second for each lamp. */
    private static final int MOST_SEEN = 2_000_000;

    private final List<SceneObject> described;
    private final List<LightSource> describedLights;
    private final Vector3dc origin;
    private final boolean followsCamera;
    private final ObjectTree objects;
    private final List<LightSource> lights;
    private final LampShadows[] lightGrids;

    /**
     * Prepares the scene of a studio.
     *
     * @param origin the place from which the scene is described to the tracer
     * @param imagePoints where the camera photographs the points that move with it
     * @param plain whether to leave out all that only saves time: the tree, and what the lamps see
     * @throws tompkins.property.InvalidPropertyException if an object is too large or too small to work with
     */
    PreparedScene(Studio studio, Vector3dc origin, ImagePoints imagePoints, boolean plain) {
        described = studio.scene();
        describedLights = studio.lights();
        this.origin = origin;
        boolean[] asked = new boolean[1];
        PrimitiveCollector collector = new PrimitiveCollector(point -> {
            asked[0] = true;
            return imagePoints.inFrame(point);
        });
        Placement placement = new Placement(1, new Matrix3d(), origin.negate(new Vector3d()));
        ObjectPreparation.add("scene", described, collector, placement);
        followsCamera = asked[0];
        objects = new ObjectTree(collector.primitives(), plain ? Integer.MAX_VALUE : ObjectTree.SMALLEST_TREE);
        lights = describedLights.stream().map(light -> light.seenFrom(origin)).toList();
        lightGrids = lightGrids(plain ? List.of() : lights, objects);
    }

    private static LampShadows[] lightGrids(List<LightSource> lights, ObjectTree objects) {
        try {
            return lights.stream()
                    .filter(light -> light.position() != null)
                    .limit(Math.min(MOST_GRIDS, MOST_SEEN / Math.max(1, objects.size())))
                    .map(light -> LampShadows.of(light.position(), objects))
                    .filter(Objects::nonNull)
                    .toArray(LampShadows[]::new);
        } catch (ArithmeticException beyondNumbers) {
            throw PrimitiveCollector.refusal("scene", "larger");
        }
    }

    /** Whether this is what {@code new PreparedScene(studio, newOrigin, ...)} would prepare for any camera. */
    boolean isOf(Studio studio, Vector3dc newOrigin) {
        return !followsCamera
                && described == studio.scene()
                && describedLights == studio.lights()
                && origin.equals(newOrigin);
    }

    ObjectTree objects() {
        return objects;
    }

    List<LightSource> lights() {
        return lights;
    }

    LampShadows[] lightGrids() {
        return lightGrids;
    }
}
