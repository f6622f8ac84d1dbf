package tompkins.camera;

import java.util.List;

/**
 * The picture of one eye within that of a camera. In its own pixels it is the ordinary picture of a camera of its own.
 *
 * @param camera the camera of this eye alone
 * @param column the column of the whole picture that is its first
 * @param row the row of the whole picture that is its first
 * @param width pixels in a row
 * @param height number of rows
 */
public record EyeView(Camera camera, int column, int row, int width, int height) {

    /** The pictures in that of a camera: one, or that of the left eye and then that of the right eye. */
    public static List<EyeView> of(Camera camera, int width, int height) {
        StereoLayout layout = camera.stereo().layout();
        if (!layout.hasHalves() && !layout.isAnaglyph()) {
            return List.of(new EyeView(camera, 0, 0, width, height));
        }
        boolean besides = layout == StereoLayout.SIDE_BY_SIDE;
        boolean below = layout == StereoLayout.TOP_AND_BOTTOM;
        int own = besides ? Math.max(1, width / 2) : width;
        int high = below ? Math.max(1, height / 2) : height;
        return List.of(
                new EyeView(alone(camera, StereoLayout.LEFT_EYE), 0, 0, own, high),
                new EyeView(alone(camera, StereoLayout.RIGHT_EYE), besides ? own : 0, below ? high : 0, own, high));
    }

    private static Camera alone(Camera camera, StereoLayout layout) {
        return camera.withStereo(camera.stereo().withLayout(layout));
    }

    /** The one of these pictures in which a position of the whole picture lies; of an anaglyph that of the left eye. */
    public static EyeView at(List<EyeView> views, double x, double y) {
        EyeView last = views.get(views.size() - 1);
        boolean inLast = last.column > 0 ? x >= last.column : last.row > 0 && y >= last.row;
        return inLast ? last : views.get(0);
    }
}
