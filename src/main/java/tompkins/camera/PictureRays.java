package tompkins.camera;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import org.joml.Vector3dc;
import tompkins.spacetime.SpaceTimeTransformation;

/** A camera that is ready to take one picture with all its eyes. Immutable, shared by all threads. */
public final class PictureRays {

    private final StereoLayout layout;
    private final List<EyeView> views;
    private final List<CameraRays> rays;
    private final CameraRays between;

    /**
     * The rays of a picture.
     *
     * @param width pixels in a row
     * @param height number of rows
     * @param sceneFromCamera the change of frame, for the shutter
     */
    public PictureRays(Camera camera, int width, int height, SpaceTimeTransformation sceneFromCamera) {
        layout = camera.stereo().layout();
        views = EyeView.of(camera, width, height);
        rays = views.stream()
                .map(view -> view.camera().rays(view.width(), view.height(), sceneFromCamera))
                .toList();
        between = layout == StereoLayout.NONE
                ? rays.get(0)
                : camera.betweenEyes().rays(views.get(0).width(), views.get(0).height(), sceneFromCamera);
    }

    /** How the pictures of the eyes are put together. */
    public StereoLayout layout() {
        return layout;
    }

    /** The pictures of the eyes. */
    public List<EyeView> views() {
        return views;
    }

    /** The picture of the eye that is followed at a position; of both in an anaglyph the left one. */
    public EyeView view(double x, double y) {
        return views.size() == 1 ? views.get(0) : EyeView.at(views, x, y);
    }

    /** The rays of one of the {@link #views}, in its own pixels. */
    public CameraRays of(EyeView view) {
        return rays.get(number(view));
    }

    /** The place of one of the {@link #views} among them. */
    public int number(EyeView view) {
        return view == views.get(0) ? 0 : 1;
    }

    /** The rays of a picture of the same size as that of an eye, taken from between the eyes. */
    public CameraRays between() {
        return between;
    }

    /** The unit direction of the ray through the centre of the lens for a point of the whole picture in pixels. */
    public Vector3dc chiefDirection(double x, double y) {
        EyeView view = view(x, y);
        return of(view).chiefDirection(x - view.column(), y - view.row());
    }

    /**
     * The positions at which the rays through the centres of the lenses have a direction: one for each eye, as far as
     * it looks there, and within its half of the picture if it has one.
     *
     * @param direction unit vector in the camera frame
     */
    public List<Vector2dc> positions(Vector3dc direction) {
        List<Vector2dc> positions = new ArrayList<>();
        for (EyeView view : views) {
            Vector2dc own = of(view).position(direction);
            Vector2dc whole = own == null ? null : new Vector2d(view.column(), view.row()).add(own);
            if (whole != null && (!layout.hasHalves() || view(whole.x(), whole.y()) == view)) {
                positions.add(whole);
            }
        }
        return positions;
    }
}
