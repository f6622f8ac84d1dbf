package tompkins.physics;

import java.util.List;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.camera.Camera;
import tompkins.camera.Cameras;
import tompkins.camera.PanoramicCamera;
import tompkins.camera.ThinLensCamera;
import tompkins.image.LinearImage;
import tompkins.ray.Colour;
import tompkins.render.RenderJob;
import tompkins.render.Renderer;
import tompkins.sceneobject.SceneObject;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.surface.LuminousSurface;
import tompkins.surface.Surface;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;

/** A studio and its rendered picture, measured as one measures a photograph. */
final class Photograph {

    static final Surface WHITE = new LuminousSurface(Colour.WHITE, false);
    static final Surface RED = new LuminousSurface(new Colour(1, 0, 0), false);
    static final Surface GREEN = new LuminousSurface(new Colour(0, 1, 0), false);

    private final Studio studio;
    private final RenderPlan plan;
    private RenderJob job;
    private LinearImage image;

    Photograph(Studio studio) {
        this.studio = studio;
        plan = RenderPlan.of(studio);
    }

    /** Objects before a black sky, a camera with the given velocity, one sample per pixel. */
    static Photograph of(List<SceneObject> scene, Camera camera, Velocity velocity, int width, int height) {
        return new Photograph(Studios.dark()
                .withScene(scene)
                .withCamera(camera)
                .withVelocity(velocity)
                .withSettings(Studio.DEFAULT.settings().withSize(width, height)));
    }

    /** A pinhole at the origin of the camera frame with a shutter in the aperture. */
    static ThinLensCamera pinhole(Vector3dc view, double horizontalAngleDegrees, double time) {
        Vector3d top = Math.abs(view.y()) < 0.9 * view.length() ? new Vector3d(0, 1, 0) : new Vector3d(0, 0, 1);
        return Cameras.lens(
                new Vector3d(),
                view,
                top,
                horizontalAngleDegrees,
                0,
                0,
                ThinLensCamera.DEFAULT.focus(),
                0,
                new AperturePlaneShutter(time));
    }

    /** A camera that sees the whole sky; its poles lie up and down. */
    static PanoramicCamera wholeSky() {
        return PanoramicCamera.DEFAULT;
    }

    Studio studio() {
        return studio;
    }

    RenderPlan plan() {
        return plan;
    }

    LinearImage image() {
        if (image == null) {
            image = job().image();
        }
        return image;
    }

    RenderJob job() {
        if (job == null) {
            try (Renderer renderer = new Renderer(2)) {
                job = renderer.render(plan);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                throw new IllegalStateException(e);
            }
        }
        return job;
    }

    boolean isLit(int column, int row, int channel) {
        return image().value(column, row, channel) > 0.5;
    }

    /** The direction that belongs to a place in the picture, in the camera frame. */
    Vector3d cameraDirection(Vector2d place) {
        return new Vector3d(studio.camera()
                .rays(plan.width(), plan.height(), studio.sceneFromCamera())
                .chiefDirection(place.x, place.y));
    }

    /** The ray of a place in the picture, followed through both frames. */
    SampleHistory trace(double x, double y) {
        return SampleHistory.of(plan, x, y, 0, 0);
    }
}
