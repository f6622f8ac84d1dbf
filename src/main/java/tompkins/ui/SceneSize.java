package tompkins.ui;

import java.lang.reflect.RecordComponent;
import java.util.List;
import org.joml.Vector3dc;
import tompkins.ray.MeshData;
import tompkins.sceneobject.SceneObject;
import tompkins.studio.Studio;
import tompkins.surface.Surface;

/** How large a scene is, so that sliders have sensible ends. */
final class SceneSize {

    /** How large a scene was when it was asked last. */
    private record Measured(List<SceneObject> scene, double size) {}

    /** A scene with many objects takes a while, and stays the same while sliders move. */
    private static volatile Measured last = new Measured(List.of(), 0);

    private SceneSize() {}

    /** The largest coordinate that an object of the scene or the focus mentions; at least 1. */
    static double of(Studio studio) {
        double focus = Cameras.focusDistance(studio.camera());
        return Math.max(Double.isFinite(focus) ? focus : 1, Math.max(1, of(studio.scene())));
    }

    private static double of(List<SceneObject> scene) {
        Measured known = last;
        if (known.scene != scene) {
            known = new Measured(scene, largest(scene));
            last = known;
        }
        return known.size;
    }

    private static double largest(Object value) {
        if (value instanceof Vector3dc vector) {
            return Math.max(Math.abs(vector.x()), Math.max(Math.abs(vector.y()), Math.abs(vector.z())));
        }
        if (value instanceof List<?> list) {
            return list.stream().mapToDouble(SceneSize::largest).max().orElse(0);
        }
        if (value instanceof MeshData mesh) {
            return mesh.largestCoordinate();
        }
        double largest = 0;
        if (value instanceof Record && !(value instanceof Surface)) {
            for (RecordComponent component : Records.components(value.getClass())) {
                largest = Math.max(largest, largest(Records.get(value, component)));
            }
        }
        return largest;
    }

    /** A slider for times: a little more than light needs through the scene, and far enough for the time that is set. */
    static Range times(Studio studio) {
        double time = Math.abs(studio.camera().shutter().openingTime());
        double end = Numbers.niceCeiling(Math.max(1.2 * of(studio), time));
        return Range.even(-end, end);
    }
}
