package tompkins.camera;

import java.util.List;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.property.InvalidPropertyException;
import tompkins.property.Meaning;
import tompkins.property.NumberText;
import tompkins.property.Require;

/**
 * The eyes of a camera: two equal lenses that rest in the camera frame, half the eye distance left and right of its
 * position, and open by the same shutter. Their detectors are parallel and shifted, so that both show a point straight
 * ahead of the camera, at the distance of zero parallax, in the middle of their pictures. The columns at which a lens
 * with f pixels for a slope of 1 shows a point at depth z differ by f s (1/z0 - 1/z), right eye less left eye.
 */
@Meaning("The pictures of two eyes, which rest in the camera frame left and right of the camera's position")
public record Stereo(
        @Meaning("How the pictures of both eyes are shown; with none there is one, from between the eyes")
        StereoLayout layout,

        @Meaning(value = "Distance between the eyes, 0 to 1e50", unit = "length")
        double eyeDistance,

        @Meaning(
                value = "Distance of what both eyes show at the same place of their pictures, more than half the"
                        + " eyeDistance, up to 1e50",
                unit = "length")
        double zeroParallaxDistance) {

    /** One picture; two eyes would be as far apart as is comfortable for what is 10 away. */
    public static final Stereo DEFAULT = new Stereo(StereoLayout.NONE, 0.3, 10);

    /** Checks the values. */
    public Stereo {
        Require.duration("eyeDistance", eyeDistance);
        Require.distance("zeroParallaxDistance", zeroParallaxDistance);
        if (zeroParallaxDistance <= eyeDistance / 2) {
            throw new InvalidPropertyException(
                    "zeroParallaxDistance",
                    "more than half the eyeDistance " + NumberText.of(eyeDistance),
                    zeroParallaxDistance);
        }
    }

    /** The same eyes in another layout. */
    public Stereo withLayout(StereoLayout other) {
        return new Stereo(other, eyeDistance, zeroParallaxDistance);
    }

    /** How far the lens is to the right of the camera's position; 0 for a picture that is not that of one eye. */
    double offset() {
        return layout.side() * eyeDistance / 2;
    }

    /** The slope against the view at which this lens sees the point that it shows in the middle of the picture. */
    double middleSlope() {
        return -offset() / zeroParallaxDistance;
    }

    /** The centres of all lenses of a camera, as {@link #lens}: between the eyes, and of the eyes if it has them. */
    List<Vector3dc> lenses(Vector3dc position, Vector3dc right) {
        return layout == StereoLayout.NONE
                ? List.of(position)
                : Stream.of(StereoLayout.NONE, StereoLayout.LEFT_EYE, StereoLayout.RIGHT_EYE)
                        .map(eye -> withLayout(eye).lens(position, right))
                        .toList();
    }

    /** The centre of the lens of a camera at a position, whose eyes are set along a unit vector to the right. */
    Vector3dc lens(Vector3dc position, Vector3dc right) {
        return layout.side() == 0 ? position : new Vector3d(right).mul(offset()).add(position);
    }
}
