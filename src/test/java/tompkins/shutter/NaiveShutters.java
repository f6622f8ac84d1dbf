package tompkins.shutter;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.spacetime.NaiveFrames;

/** Shutter times as differences of distances to the point in focus, which has to be a point. */
public final class NaiveShutters {

    private NaiveShutters() {}

    /** {@code t - |pi| + |ei|} in front, with the opposite signs behind. */
    public static double idealLens(
            double openingTime,
            double detectorDistance,
            Vector3dc centre,
            Vector3dc view,
            Vector3dc pupil,
            Vector3dc image) {
        Vector3d toImage = image.sub(centre, new Vector3d());
        double side = toImage.dot(view) > 0 ? 1 : -1;
        double behind = detectorDistance * toImage.length() / Math.abs(toImage.dot(view)) * view.length();
        double centreToImage = toImage.length();
        return openingTime - behind - side * (centreToImage - pupil.distance(image));
    }

    /** With (gamma - 1)/beta^2. */
    public static double fixedPoint(Vector3dc beta, Vector3dc pupil, Vector3dc image, double side) {
        return NaiveFrames.fixedPointTime(beta, image) + side * pupil.distance(image);
    }
}
