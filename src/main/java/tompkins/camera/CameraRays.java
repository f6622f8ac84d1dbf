package tompkins.camera;

import java.util.List;
import org.joml.Vector2dc;
import org.joml.Vector3dc;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.ray.RayPacket;
import tompkins.shutter.LensRay;
import tompkins.shutter.RollingShutter;

/** A camera that is ready to take one picture. Immutable, shared by all threads. */
public abstract class CameraRays {

    private final double exposureTime;
    private final RollingShutter rolling;

    /** The lines of the picture that open one after the other: rows or columns. */
    private final int lines;

    /** The picture of a camera with a given width and height in pixels. */
    CameraRays(Camera camera, int width, int height) {
        exposureTime = camera.exposureTime();
        rolling = camera.rollingShutter();
        lines = rolling.direction().runsOverRows() ? height : width;
    }

    /**
     * Makes the rays of some samples, in the camera frame. A sample that brings no light because it never crosses the
     * shutter gets none.
     *
     * @param positions the samples
     * @param rays receives the rays, which know their samples
     * @param counts takes note of rays without focus or shutter
     */
    public final void make(SamplePositions positions, RayPacket rays, RayCounts counts) {
        rays.begin(positions.count());
        start(positions, rays, counts);
        if (rolling.rolls()) {
            int[] ofSamples = rolling.direction().runsOverRows() ? positions.rows : positions.columns;
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

    /** Lets the rays start when the shutter model says, and leaves out those that never cross the shutter. */
    abstract void start(SamplePositions positions, RayPacket rays, RayCounts counts);

    /**
     * The ray of a single sample in the middle of the exposure time, or null; for the position see
     * {@link SamplePositions#add}.
     */
    public final Ray ray(double x, double y, double lensX, double lensY, RayCounts counts) {
        RayPacket rays = new RayPacket(1);
        make(SamplePositions.single(x, y, lensX, lensY, SamplePositions.MIDDLE), rays, counts);
        return rays.count() == 0 ? null : rays.ray(0);
    }

    /**
     * What the shutter knows of the ray through the centre of the lens in a unit direction: focused where the camera is
     * focused in that direction, if lens or shutter need it; otherwise, or if nothing is in focus there, at infinity.
     */
    public abstract LensRay chiefRay(Vector3dc direction);

    /** The centre of the lens for what is seen in a unit direction; the eyes of a panorama turn with it. */
    public abstract Vector3dc lens(Vector3dc direction);

    /** The unit direction of the ray through the centre of the lens for a point of the picture in pixels. */
    public abstract Vector3dc chiefDirection(double x, double y);

    /**
     * The point of the picture in pixels at which the ray through the centre of the lens has a direction; it may lie
     * outside the edges. Null if there is none: a lens does not see what is behind it.
     *
     * @param direction unit vector in the camera frame
     */
    public abstract Vector2dc position(Vector3dc direction);

    /**
     * All points of the picture, as {@link #position}, at which a direction is seen, and those beyond its edges at
     * which it were seen if the picture went on there: one that holds all directions does.
     */
    public List<Vector2dc> positions(Vector3dc direction) {
        Vector2dc position = position(direction);
        return position == null ? List.of() : List.of(position);
    }

    /** The solid angle of a pixel, in steradians. */
    public abstract double solidAngle(int column, int row);
}
