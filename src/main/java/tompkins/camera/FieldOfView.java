package tompkins.camera;

import tompkins.property.Descriptions;
import tompkins.property.NumberText;
import tompkins.property.Require;

/**
 * Changes how wide a camera sees. The angle between top and bottom changes with the one between left and right, so that
 * pixels keep their shape, as far as possible.
 */
public final class FieldOfView {

    /** The least and the largest field of view that a factor leads to, in degrees. */
    private static final double NARROWEST = 1e-3;

    private static final double WIDEST_LENS = 170;
    private static final double WIDEST_PANORAMA = 360;

    /** Digits of an angle that is worked out by way of its tangent; the rest is rounding. */
    private static final int ANGLE_DIGITS = 12;

    private FieldOfView() {}

    /**
     * A camera with another angle between the left and the right edge of the picture, in degrees.
     *
     * @throws tompkins.property.InvalidPropertyException if no picture is so wide
     */
    public static Camera with(Camera camera, double degrees) {
        double before = camera.horizontalAngleDegrees();
        if (camera instanceof ThinLensCamera lens) {
            Require.between("horizontalAngleDegrees", degrees, 0, 180);
            double scale = halfTangent(degrees) / halfTangent(before);
            double vertical = 2 * Math.toDegrees(Math.atan(scale * halfTangent(lens.verticalAngleDegrees())));
            return angles(camera, degrees, NumberText.rounded(vertical, ANGLE_DIGITS));
        }
        Require.positive("horizontalAngleDegrees", degrees, 360);
        double vertical = ((PanoramicCamera) camera).verticalAngleDegrees();
        return angles(camera, degrees, Math.min(180, vertical * degrees / before));
    }

    private static Camera angles(Camera camera, double horizontal, double vertical) {
        return Descriptions.changed(camera, (name, value) -> switch (name) {
            case "horizontalAngleDegrees" -> horizontal;
            case "verticalAngleDegrees" -> vertical;
            default -> value;
        });
    }

    private static double halfTangent(double degrees) {
        return Math.tan(Math.toRadians(degrees) / 2);
    }

    /** A camera whose field of view is changed by a factor, as far as it goes. */
    public static Camera zoomed(Camera camera, double factor) {
        double before = camera.horizontalAngleDegrees();
        double widest = Math.max(before, camera instanceof ThinLensCamera ? WIDEST_LENS : WIDEST_PANORAMA);
        return with(camera, Math.max(NARROWEST, Math.min(widest, before * factor)));
    }
}
