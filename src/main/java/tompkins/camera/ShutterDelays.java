package tompkins.camera;

import tompkins.ray.RayPacket;
import tompkins.shutter.RollingShutter;

/**
 * What is added to the time that the shutter model gives: the delay of the line on which a sample lies, and the part of
 * the exposure time that has passed at its moment.
 */
final class ShutterDelays {

    private final double exposureTime;
    private final boolean rolls;
    private final boolean overRows;

    /** The delay of each line. */
    private final double[] ofLines;

    /** The delays for the pictures of a camera with a given width and height in pixels. */
    ShutterDelays(Camera camera, int width, int height) {
        exposureTime = camera.exposureTime();
        RollingShutter rolling = camera.rollingShutter();
        rolls = rolling.rolls();
        overRows = rolling.direction().runsOverRows();
        int lines = overRows ? height : width;
        ofLines = new double[rolls ? lines : 0];
        for (int line = 0; line < ofLines.length; line++) {
            ofLines[line] = rolling.delay(line + 0.5, lines);
        }
    }

    /** Lets each ray start as much later as its sample does; rays of an instant shutter stay as they are. */
    void addTo(RayPacket rays, SamplePositions positions) {
        if (rolls) {
            int[] lines = overRows ? positions.rows : positions.columns;
            int last = ofLines.length - 1;
            for (int i = 0; i < rays.count(); i++) {
                // a position on the far edge of the picture belongs to its last line
                rays.time[i] += ofLines[Math.max(0, Math.min(last, lines[rays.sample(i)]))];
            }
        }
        if (exposureTime > 0) {
            for (int i = 0; i < rays.count(); i++) {
                rays.time[i] += exposureTime * positions.moments[rays.sample(i)];
            }
        }
    }
}
