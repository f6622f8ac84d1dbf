package tompkins.measure;

import java.util.function.Function;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.camera.Camera;
import tompkins.camera.CameraRays;
import tompkins.camera.PanoramicCamera;
import tompkins.math.Vectors;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.shutter.RollingShutter;
import tompkins.spacetime.Event;
import tompkins.studio.Studio;

/**
 * Where a picture shows something: leads from a direction or a point to a place in pixels, for the centre of the lens,
 * in the middle of the exposure, with nothing before the lens. The centre of pixel (i, j) is (i + 1/2, j + 1/2). If the
 * shutter opens at another time for each place, the time is found at which the place shows the object.
 */
public final class Projection {

    /** A place counts as found if it moves by less than this from step to step, in pixels. */
    private static final double SETTLED = 1e-4;

    private static final int MOST_STEPS = 60;

    /** How often the time is corrected to that of the line on which the place lies. */
    private static final int LINE_STEPS = 4;

    private final Studio studio;
    private final int width;
    private final int height;
    private final CameraRays rays;
    private final Vector3dc lens;
    private final RollingShutter rolling;
    private final boolean oneTime;
    private final double middleTime;

    /** The projection of a studio's picture in the size of its settings. */
    public static Projection of(Studio studio) {
        return new Projection(
                studio, studio.settings().width(), studio.settings().height());
    }

    /** The projection of a studio's picture in another size. */
    public Projection(Studio studio, int width, int height) {
        this.studio = studio;
        this.width = width;
        this.height = height;
        Camera camera = studio.camera();
        rays = camera.rays(width, height, studio.sceneFromCamera());
        lens = camera.position();
        rolling = camera.rollingShutter();
        oneTime = camera.shutter() instanceof AperturePlaneShutter && !rolling.rolls();
        middleTime = time(width / 2.0, height / 2.0);
    }

    /** The studio whose picture this is. */
    public Studio studio() {
        return studio;
    }

    /** Pixels in a row. */
    public int width() {
        return width;
    }

    /** Number of rows. */
    public int height() {
        return height;
    }

    /** Whether the shutter opens at one time for all places, so that places are found at once. */
    public boolean hasOneTime() {
        return oneTime;
    }

    /** Columns after which a panorama repeats; infinite for a lens. */
    public double columnsAround() {
        return studio.camera() instanceof PanoramicCamera panorama
                ? width * 360 / panorama.horizontalAngleDegrees()
                : Double.POSITIVE_INFINITY;
    }

    /** The unit direction, in the camera frame, that is seen at a place. */
    public Vector3dc direction(double x, double y) {
        return rays.chiefDirection(x, y);
    }

    /** The place at which a unit direction of the camera frame is seen; null if it lies behind the lens. */
    public Vector2dc place(Vector3dc direction) {
        return rays.place(direction);
    }

    /** The time, in the camera frame, at which light for a place crosses the centre of the lens; NaN if none does. */
    public double time(double x, double y) {
        Ray ray = rays.ray(x, y, 0, 0, new RayCounts());
        return ray == null ? Double.NaN : ray.time;
    }

    /** The event, in the camera frame, at which light for the middle of the picture crosses the centre of the lens. */
    public Event lensEvent() {
        return lensAt(Double.isNaN(middleTime) ? 0 : middleTime);
    }

    private Event lensAt(double time) {
        return new Event(lens.x(), lens.y(), lens.z(), time);
    }

    /** The place at which a point that rests in a frame is seen; null if it is out of sight. */
    public Vector2dc place(SeenFrame frame, Vector3dc point) {
        return place(event -> {
            Vector3d towards = point.sub(frame.fromCamera(event).position(), new Vector3d());
            return towards.lengthSquared() > 0 ? frame.look(towards) : null;
        });
    }

    /**
     * The place at which something is seen, given its direction for each event at the lens.
     *
     * @param look gives a unit vector in the camera frame, or null if it is not seen
     * @return its place, which may lie outside the edges, or null if it is behind the lens, or if no time was found
     */
    public Vector2dc place(Function<Event, ? extends Vector3dc> look) {
        double time = lensEvent().time();
        if (oneTime) {
            return placeAt(look, time);
        }
        double settled = settledTime(look, time);
        if (Double.isNaN(settled)) {
            return null;
        }
        return rolling.rolls() ? ofOneLine(look, settled) : placeAt(look, settled);
    }

    private Vector2dc placeAt(Function<Event, ? extends Vector3dc> look, double time) {
        Vector3dc direction = look.apply(lensAt(time));
        return direction == null ? null : rays.place(direction);
    }

    /**
     * The time at which the shutter opens at the place where the object is seen at that time, found by the secant
     * method; NaN if there is none.
     */
    private double settledTime(Function<Event, ? extends Vector3dc> look, double start) {
        double before = Double.NaN;
        double errorBefore = Double.NaN;
        double time = start;
        Vector2dc placeBefore = null;
        for (int step = 0; step < MOST_STEPS; step++) {
            Vector2dc place = placeAt(look, time);
            double error = place == null ? Double.NaN : smoothTime(place) - time;
            if (Double.isNaN(error)) {
                return Double.NaN;
            }
            if (error == 0
                    || placeBefore != null && place.distance(placeBefore) < SETTLED && settles(look, time, error)) {
                return time + error;
            }
            double slope = (error - errorBefore) / (time - before);
            before = time;
            errorBefore = error;
            placeBefore = place;
            time = Double.isFinite(slope) && slope < 0 ? time - error / slope : time + error;
        }
        return Double.NaN;
    }

    private boolean settles(Function<Event, ? extends Vector3dc> look, double time, double error) {
        Vector2dc here = placeAt(look, time);
        Vector2dc there = placeAt(look, time + error);
        return here != null && there != null && here.distance(there) < SETTLED;
    }

    /** The time by the model of the shutter and the middle of the exposure, without the delay of a line. */
    private double timeWithoutDelay(Vector2dc place) {
        double time = time(place.x(), place.y());
        return rolling.rolls() ? time - rolling.delay(line(place), lines()) : time;
    }

    /** As {@link #time}, but as if the lines of a rolling shutter had no width. */
    private double smoothTime(Vector2dc place) {
        double time = timeWithoutDelay(place);
        if (!rolling.rolls()) {
            return time;
        }
        int lines = lines();
        double along = Math.max(0.5, Math.min(lines - 0.5, acrossLines(place)));
        double first = rolling.delay(0, lines);
        double perLine = lines == 1 ? 0 : (rolling.delay(lines - 1, lines) - first) / (lines - 1);
        return time + first + perLine * (along - 0.5);
    }

    /** The place for a shutter that opens a whole line together: at the time of the line in which it lies. */
    private Vector2dc ofOneLine(Function<Event, ? extends Vector3dc> look, double smooth) {
        Vector2dc near = placeAt(look, smooth);
        Vector2dc best = near;
        double least = Double.POSITIVE_INFINITY;
        for (int step = -1; step <= 1 && near != null; step++) {
            int line = Math.max(0, Math.min(lines() - 1, line(near) + step));
            Vector2dc place = near;
            for (int again = 0; again < LINE_STEPS && place != null; again++) {
                place = placeAt(look, timeWithoutDelay(place) + rolling.delay(line, lines()));
            }
            double miss = place == null ? Double.NaN : Math.abs(acrossLines(place) - line - 0.5);
            if (miss < least) {
                least = miss;
                best = place;
            }
        }
        return best;
    }

    private int lines() {
        return rolling.direction().runsOverRows() ? height : width;
    }

    private double acrossLines(Vector2dc place) {
        return rolling.direction().runsOverRows() ? place.y() : place.x();
    }

    private int line(Vector2dc place) {
        return (int) Math.max(0, Math.min(lines() - 1, Math.floor(acrossLines(place))));
    }

    /** The angle that one pixel covers at a place, in radians: the larger of width and height. */
    public double pixelAngle(double x, double y) {
        Vector3dc here = direction(x, y);
        return Math.max(
                Angles.between(here, Vectors.unit(direction(x + 1, y))),
                Angles.between(here, Vectors.unit(direction(x, y + 1))));
    }
}
