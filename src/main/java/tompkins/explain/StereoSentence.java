package tompkins.explain;

import java.util.Optional;
import org.joml.Vector3dc;
import tompkins.camera.Camera;
import tompkins.camera.EyeView;
import tompkins.camera.PanoramicCamera;
import tompkins.camera.PictureRays;
import tompkins.camera.Stereo;
import tompkins.math.Vectors;
import tompkins.property.NumberText;

/** Says how the pictures of two eyes are taken and shown. */
final class StereoSentence {

    private StereoSentence() {}

    /** The sentences; nothing for a camera that takes one picture from between the eyes. */
    static Optional<String> of(Camera camera, PictureRays rays) {
        Stereo stereo = camera.stereo();
        String layout = switch (stereo.layout()) {
            case NONE -> "";
            case LEFT_EYE -> "The picture of the left of two eyes";
            case RIGHT_EYE -> "The picture of the right of two eyes";
            case SIDE_BY_SIDE -> "The left half is the picture of the left eye, the right half that of the right eye";
            case TOP_AND_BOTTOM ->
                "The upper half is the picture of the left eye, the lower half that of the right eye";
            case ANAGLYPH -> "An anaglyph: red of the left eye, green and blue of the right eye";
            case GREY_ANAGLYPH ->
                "A grey anaglyph: the luminance of the left eye in red, that of the right eye in green and blue";
        };
        if (layout.isEmpty()) {
            return Optional.empty();
        }
        String turning = camera instanceof PanoramicCamera
                ? " They turn about the camera's position with the columns, each of which they see straight ahead of them."
                : "";
        String both = stereo.layout().hasBothEyes() ? farthest(camera, rays) : "";
        String followed = stereo.layout().isAnaglyph()
                ? " Each sample follows a ray of each eye; the ray that is traced for a point is that of the left eye."
                : "";
        return Optional.of(layout + ". The eyes rest in the camera frame, " + NumberText.of(stereo.eyeDistance())
                + " apart, and both show what is " + NumberText.of(stereo.zeroParallaxDistance())
                + " straight ahead in the middle of their pictures." + turning + both + followed);
    }

    /** By how much the pictures of the eyes differ for what is infinitely far away. */
    private static String farthest(Camera camera, PictureRays rays) {
        Vector3dc ahead = Vectors.unit(camera.viewDirection());
        EyeView left = rays.views().get(0);
        EyeView right = rays.views().get(1);
        double parallax = rays.of(right).position(ahead).x()
                - rays.of(left).position(ahead).x();
        return " What is infinitely far away is " + NumberText.plain(parallax, 3)
                + " pixels farther to the right for the right eye.";
    }
}
