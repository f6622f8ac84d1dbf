package tompkins.studio;

import org.joml.Quaterniondc;
import org.joml.Vector3dc;
import tompkins.camera.Camera;
import tompkins.camera.CameraMotion;
import tompkins.math.RigidMotion;
import tompkins.math.Vectors;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.shutter.LensRay;
import tompkins.spacetime.Event;
import tompkins.spacetime.SpaceTimeTransformation;
import tompkins.spacetime.Velocity;

/**
 * The event of a photograph: the light for the middle of the picture crosses the centre of the lens. The place of a
 * camera in its rest frame says little while it moves; this event says where the camera is in the scene, and when.
 */
public final class LensEvent {

    private LensEvent() {}

    /** When light for the middle of the picture crosses the lens by the shutter model; not finite if none does. */
    public static double timeInMiddle(Camera camera, SpaceTimeTransformation sceneFromCamera) {
        LensRay middle =
                camera.betweenEyes().rays(1, 1, sceneFromCamera).chiefRay(Vectors.unit(camera.viewDirection()));
        return camera.shutter().transmissionTime(middle, sceneFromCamera);
    }

    /** The event in the camera frame amid exposure and sweep; at time 0 if no light crosses the shutter. */
    public static Event inCamera(Studio studio) {
        Camera camera = studio.camera();
        Vector3dc place = camera.position();
        Ray axis = camera.betweenEyes().rays(1, 1, studio.sceneFromCamera()).ray(0.5, 0.5, 0, 0, new RayCounts());
        return new Event(place.x(), place.y(), place.z(), axis == null ? 0 : axis.time);
    }

    /** The event in the scene frame. */
    public static Event inScene(Studio studio) {
        return studio.sceneFromCamera().transform(inCamera(studio));
    }

    /**
     * The studio with its camera at another event and with another velocity; the objects that move with the camera, its
     * focus and its shutter go along. A shutter without an opening time is replaced by one in the aperture.
     *
     * @param inScene the event, in the scene frame
     * @param turn how the camera is turned against the axes of its frame
     * @throws tompkins.property.InvalidPropertyException if the place is too far away, or the velocity too large
     */
    public static Studio moved(Studio studio, Event inScene, Velocity velocity, Quaterniondc turn) {
        Studio timed = withOpeningTime(studio);
        Event before = inCamera(timed);
        Studio faster = FrontWindow.withVelocity(timed, velocity);
        Event after = faster.sceneFromCamera().inverse().transform(inScene);
        RigidMotion motion = RigidMotion.about(before.position(), turn, after.position());
        Camera moved = CameraMotion.moved(faster.camera(), motion);
        double opening = moved.shutter().openingTime() + (after.time() - before.time());
        return faster.withCamera(moved.withShutter(moved.shutter().openedAt(opening)))
                .withCameraFrame(faster.cameraFrame().stream()
                        .map(object -> object.moved(motion))
                        .toList());
    }

    private static Studio withOpeningTime(Studio studio) {
        Camera camera = studio.camera();
        if (camera.shutter().hasOpeningTime()) {
            return studio;
        }
        double time = timeInMiddle(camera, studio.sceneFromCamera());
        return studio.withCamera(camera.withShutter(new AperturePlaneShutter(Double.isFinite(time) ? time : 0)));
    }
}
