package tompkins.camera;

import tompkins.ray.RayPacket;
import tompkins.shutter.RollingShutter;

/** What is added to the time of the shutter model: the delay of the line, and the exposure time that has passed. */
final class ShutterDelays {

    private final double exposureTime;
    private final RollingShutter rolling;
    private final boolean overRows;
    private final int lines;

    /** The delays for the pictures of a camera with a given width and height in pixels. */
    ShutterDelays(Camera camera, int width, int height) {
        exposureTime = camera.exposureTime();
        rolling = camera.rollingShutter();
        overRows = rolling.direction().runsOverRows();
        lines = overRows ? height : width;
    }

    /** Lets each ray start as much later as its sample does; rays of an instant shutter stay as they are. */
    void addTo(RayPacket rays, SamplePositions positions) {
        if (rolling.rolls()) {
            int[] ofSamples = overRows ? positions.rows : positions.columns;
            for (int i = 0; i < rays.count(); i++) {
                // a position on the far edge of the picture belongs to its last line
                int line = Math.max(0, Math.min(lines - 1, ofSamples[rays.sample(i)]));
                rays.time[i] += rolling.delay(line + 0.5, lines);
            }
        }
        if (exposureTime > 0) {
            for (int i = 0; i < rays.count(); i++) {
                rays.time[i] += exposureTime * positions.moments[rays.sample(i)];
            }
        }
    }
}
