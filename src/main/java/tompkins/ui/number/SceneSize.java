package tompkins.ui.number;

import java.util.List;
import org.joml.Vector3dc;
import tompkins.camera.FocusDistance;
import tompkins.property.Descriptions;
import tompkins.ray.MeshData;
import tompkins.sceneobject.SceneObject;
import tompkins.studio.Studio;
import tompkins.surface.Surface;
import tompkins.ui.widget.Numbers;
import tompkins.ui.widget.Range;

/**
 * How large a scene is, so that sliders have sensible ends. Remembers it as long as the scene does not change, because
 * it may have many objects.
 */
public final class SceneSize {

    private List<SceneObject> scene;
    private double coordinate;

    /** The largest coordinate in an object of the scene or in the focus; at least 1. */
    public double of(Studio studio) {
        double focus = FocusDistance.of(studio.camera());
        if (scene != studio.scene()) {
            scene = studio.scene();
            coordinate = largest(scene);
        }
        return Math.max(Double.isFinite(focus) ? focus : 1, Math.max(1, coordinate));
    }

    private static double largest(Object value) {
        if (value instanceof Vector3dc vector) {
            return Math.max(Math.abs(vector.x()), Math.max(Math.abs(vector.y()), Math.abs(vector.z())));
        }
        if (value instanceof MeshData mesh) {
            return mesh.largestCoordinate();
        }
        List<?> parts = value instanceof Surface ? List.of() : Descriptions.parts(value);
        return parts.stream().mapToDouble(SceneSize::largest).max().orElse(0);
    }

    /**
     * A slider for times: a little more than light needs to cross the scene, and far enough for the time that is set.
     */
    public Range times(Studio studio) {
        double time = Math.abs(studio.camera().shutter().openingTime());
        double end = Numbers.niceCeiling(Math.max(1.2 * of(studio), time));
        return Range.even(-end, end);
    }

    /**
     * A slider for spans of time: fine near 0, up to a little more than light needs to cross the scene, and at least to
     * the given one.
     */
    public Range spans(Studio studio, double span) {
        return new Range(0, Numbers.niceCeiling(Math.max(1.2 * of(studio), span)), 2);
    }
}
