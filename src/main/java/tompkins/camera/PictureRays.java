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
        boolean besides = layout == StereoLayout.SIDE_BY_SIDE;
        boolean below = layout == StereoLayout.TOP_AND_BOTTOM;
        int own = besides ? Math.max(1, width / 2) : width;
        int high = below ? Math.max(1, height / 2) : height;
        if (layout.hasHalves() || layout.isAnaglyph()) {
            Camera left = camera.withStereo(camera.stereo().withLayout(StereoLayout.LEFT_EYE));
            Camera right = camera.withStereo(camera.stereo().withLayout(StereoLayout.RIGHT_EYE));
            views = List.of(
                    new EyeView(left, 0, 0, own, high, sceneFromCamera),
                    new EyeView(right, besides ? own : 0, below ? high : 0, own, high, sceneFromCamera));
        } else {
            views = List.of(new EyeView(camera, 0, 0, width, height, sceneFromCamera));
        }
        between = layout == StereoLayout.NONE
                ? views.get(0).rays()
                : camera.betweenEyes().rays(own, high, sceneFromCamera);
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
        EyeView last = views.get(views.size() - 1);
        boolean inLast = last.column() > 0 ? x >= last.column() : last.row() > 0 && y >= last.row();
        return inLast ? last : views.get(0);
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
        return view.rays().chiefDirection(x - view.column(), y - view.row());
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
            Vector2dc own = view.rays().position(direction);
            Vector2dc whole = own == null ? null : new Vector2d(view.column(), view.row()).add(own);
            if (whole != null && (!layout.hasHalves() || view(whole.x(), whole.y()) == view)) {
                positions.add(whole);
            }
        }
        return positions;
    }
}
