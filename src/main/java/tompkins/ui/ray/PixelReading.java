package tompkins.ui.ray;

import java.awt.geom.Point2D;
import tompkins.camera.Camera;
import tompkins.camera.FocusDistance;
import tompkins.measure.Sighting;
import tompkins.spacetime.Event;
import tompkins.ui.picture.Picture;

/**
 * What lies under a pixel: what its ray hits, where and when, in both frames.
 *
 * @param column column of the pixel, in the photograph's own size
 * @param row row of the pixel
 * @param sighting what is seen there
 */
public record PixelReading(int column, int row, Sighting sighting) {

    /** Follows the ray of a place of a picture, in pixels of its photograph; for threads that may take their time. */
    public static PixelReading of(Picture picture, Point2D place) {
        Point2D inPixels = picture.inPixels(place);
        return new PixelReading(
                (int) place.getX(), (int) place.getY(), Sighting.of(picture.plan(), inPixels.getX(), inPixels.getY()));
    }

    /** The distance at which a camera has to be focused for what was read to be sharp, or NaN. */
    public double depth(Camera camera) {
        Event seen = sighting.inCamera();
        return seen == null ? Double.NaN : FocusDistance.toPoint(camera, seen.position());
    }
}
