package tompkins.camera;

import org.joml.Quaterniond;
import org.joml.Vector3dc;
import tompkins.math.RigidMotion;
import tompkins.property.Descriptions;
import tompkins.sceneobject.SceneObject;
import tompkins.shutter.Shutter;

/** Moves and turns cameras in their rest frame. Its shutter and the surface in focus go along. */
public final class CameraMotion {

    private CameraMotion() {}

    /** A camera after a motion. */
    public static Camera moved(Camera camera, RigidMotion motion) {
        return moved(
                camera,
                motion,
                motion.place(camera.position()),
                motion.direction(camera.viewDirection()),
                motion.direction(camera.topDirection()));
    }

    /** A camera that is shifted by a vector. */
    public static Camera shifted(Camera camera, Vector3dc shift) {
        return moved(camera, new RigidMotion(new Quaterniond(), shift));
    }

    /**
     * A camera that is turned about the centre of its lens.
     *
     * @throws tompkins.property.InvalidPropertyException if the directions are parallel
     */
    public static Camera turned(Camera camera, Vector3dc view, Vector3dc top) {
        CameraAxes.requireTop(top, view);
        RigidMotion turn = RigidMotion.about(
                camera.position(), CameraAxes.of(view, top).turnFrom(axes(camera)), camera.position());
        return moved(camera, turn, camera.position(), view, top);
    }

    /** The motion that takes the lens and the axes of one camera to those of another. */
    public static RigidMotion between(Camera from, Camera to) {
        return RigidMotion.about(from.position(), axes(to).turnFrom(axes(from)), to.position());
    }

    private static CameraAxes axes(Camera camera) {
        return CameraAxes.of(camera.viewDirection(), camera.topDirection());
    }

    /** Sets the place and the directions as given, so that those that do not change are not rounded. */
    private static Camera moved(Camera camera, RigidMotion motion, Vector3dc position, Vector3dc view, Vector3dc top) {
        boolean hasDistance = camera instanceof ThinLensCamera lens && lens.focusDistance() > 0;
        return Descriptions.changed(camera, (name, value) -> switch (name) {
            case "position" -> position;
            case "viewDirection" -> view;
            case "topDirection" -> top;
            case "focus" -> hasDistance ? value : moved(value, motion);
            default -> moved(value, motion);
        });
    }

    private static Object moved(Object value, RigidMotion motion) {
        if (value instanceof SceneObject object) {
            return object.moved(motion);
        }
        return value instanceof Shutter shutter ? shutter.moved(motion) : value;
    }
}
