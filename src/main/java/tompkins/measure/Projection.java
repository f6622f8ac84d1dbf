package tompkins.measure;

import java.util.List;
import java.util.function.Function;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.camera.CameraRays;
import tompkins.camera.EyeView;
import tompkins.camera.PanoramicCamera;
import tompkins.camera.PictureRays;
import tompkins.math.Vectors;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.shutter.RollingShutter;
import tompkins.spacetime.Event;
import tompkins.studio.Studio;
import tompkins.world.FrameAppearance;

/**
 * Where a picture shows something: leads from a direction or a point to a position in pixels, for the centre of the
 * lens, in the middle of the exposure, with nothing before the lens. The centre of pixel (i, j) is (i + 1/2, j + 1/2).
 * If the shutter opens at another time for each position, the time is found at which the position shows the object.
 */
public final class Projection {

    /** A position counts as found if it moves by less than this from step to step, in pixels. */
    private static final double SETTLED = 1e-4;

    private static final int MOST_STEPS = 60;

    /** The lens of an eye that turns counts as found if it moves by less than this part of the eye distance. */
    private static final double LENS_SETTLED = 1e-9;

    /** How often the time is corrected to that of the line on which the position lies. */
    private static final int LINE_STEPS = 4;

    private final Studio studio;
    private final EyeView view;
    private final CameraRays rays;
    private final Vector3dc lens;
    private final RollingShutter rolling;
    private final boolean oneTime;
    private final double middleTime;

    /** The projections of the eyes of a studio in a picture of the size of its settings. */
    public static List<Projection> ofEyes(Studio studio) {
        List<EyeView> views = rays(studio).views();
        return views.stream().map(view -> new Projection(studio, view)).toList();
    }

    /** The projection of a studio's picture in the size of its settings; if it has two eyes, that of the left one. */
    public static Projection of(Studio studio) {
        return ofEyes(studio).get(0);
    }

    /** The projection of the eye in whose part of the picture a position lies. */
    static Projection at(Studio studio, Vector2dc position) {
        return new Projection(studio, rays(studio).view(position.x(), position.y()));
    }

    private static PictureRays rays(Studio studio) {
        return new PictureRays(
                studio.camera(), studio.settings().width(), studio.settings().height(), studio.sceneFromCamera());
    }

    private Projection(Studio studio, EyeView view) {
        this.studio = studio;
        this.view = view;
        rays = view.rays();
        lens = rays.lens(rays.chiefDirection(view.width() / 2.0, view.height() / 2.0));
        rolling = studio.camera().rollingShutter();
        oneTime = studio.camera().shutter() instanceof AperturePlaneShutter && !rolling.rolls();
        middleTime = time(middle().x(), middle().y());
    }

    /** The studio whose picture this is. */
    public Studio studio() {
        return studio;
    }

    /** The part of the whole picture that is projected; positions are those in the whole picture. */
    public EyeView view() {
        return view;
    }

    /** The position in the middle of the picture. */
    public Vector2d middle() {
        return new Vector2d(view.column() + view.width() / 2.0, view.row() + view.height() / 2.0);
    }

    /** Whether a position, which may be null, lies within the edges of the picture. */
    public boolean shows(Vector2dc position) {
        return position != null
                && position.x() >= view.column()
                && position.y() >= view.row()
                && position.x() <= view.column() + view.width()
                && position.y() <= view.row() + view.height();
    }

    /** Whether the shutter opens at one time for all positions, so that positions are found at once. */
    public boolean hasOneTime() {
        return oneTime;
    }

    /** Columns after which a panorama repeats; infinite for a lens. */
    public double columnsAround() {
        return studio.camera() instanceof PanoramicCamera panorama
                ? view.width() * 360 / panorama.horizontalAngleDegrees()
                : Double.POSITIVE_INFINITY;
    }

    /** The unit direction, in the camera frame, that is seen at a position. */
    public Vector3dc direction(double x, double y) {
        return new Vector3d(rays.chiefDirection(x - view.column(), y - view.row()));
    }

    /** The position at which a unit direction of the camera frame is seen; null if it lies behind the lens. */
    public Vector2dc position(Vector3dc direction) {
        Vector2dc own = rays.position(direction);
        return own == null ? null : new Vector2d(view.column(), view.row()).add(own);
    }

    /**
     * The time, in the camera frame, at which light for a position crosses the centre of the lens; NaN if none does.
     */
    public double time(double x, double y) {
        Ray ray = rays.ray(x - view.column(), y - view.row(), 0, 0, new RayCounts());
        return ray == null ? Double.NaN : ray.time;
    }

    /** The event, in the camera frame, at which light for the middle of the picture crosses the centre of the lens. */
    public Event lensEvent() {
        return at(lens, Double.isNaN(middleTime) ? 0 : middleTime);
    }

    private static Event at(Vector3dc place, double time) {
        return new Event(place.x(), place.y(), place.z(), time);
    }

    /** The position at which a point that rests in a frame is seen; null if it is out of sight. */
    public Vector2dc position(FrameAppearance frame, Vector3dc point) {
        return position(event -> {
            Vector3d towards = point.sub(frame.fromCamera(event).position(), new Vector3d());
            return towards.lengthSquared() > 0 ? frame.look(towards) : null;
        });
    }

    /**
     * The position at which something is seen, given its direction for each event at the lens.
     *
     * @param look gives a unit vector in the camera frame, or null if it is not seen
     * @return its position, which may lie outside the edges, or null if it is behind the lens, or if no time was found
     */
    public Vector2dc position(Function<Event, ? extends Vector3dc> look) {
        double time = lensEvent().time();
        if (oneTime) {
            return positionAt(look, time);
        }
        double settled = settledTime(look, time);
        if (Double.isNaN(settled)) {
            return null;
        }
        return rolling.rolls() ? ofOneLine(look, settled) : positionAt(look, settled);
    }

    private Vector2dc positionAt(Function<Event, ? extends Vector3dc> look, double time) {
        double settled = LENS_SETTLED * studio.camera().stereo().eyeDistance();
        Vector3dc from = lens;
        for (int step = 0; step < MOST_STEPS; step++) {
            Vector3dc direction = look.apply(at(from, time));
            if (direction == null) {
                return null;
            }
            Vector3dc there = rays.lens(direction);
            if (there.distance(from) <= settled) {
                return position(direction);
            }
            from = there;
        }
        return null;
    }

    /** The time at which the shutter opens where the object is seen then, by the secant method; or NaN. */
    private double settledTime(Function<Event, ? extends Vector3dc> look, double start) {
        double before = Double.NaN;
        double errorBefore = Double.NaN;
        double time = start;
        Vector2dc positionBefore = null;
        for (int step = 0; step < MOST_STEPS; step++) {
            Vector2dc position = positionAt(look, time);
            double error = position == null ? Double.NaN : smoothTime(position) - time;
            if (Double.isNaN(error)) {
                return Double.NaN;
            }
            if (error == 0
                    || positionBefore != null
                            && position.distance(positionBefore) < SETTLED
                            && settles(look, time, error)) {
                return time + error;
            }
            double slope = (error - errorBefore) / (time - before);
            before = time;
            errorBefore = error;
            positionBefore = position;
            time = Double.isFinite(slope) && slope < 0 ? time - error / slope : time + error;
        }
        return Double.NaN;
    }

    private boolean settles(Function<Event, ? extends Vector3dc> look, double time, double error) {
        Vector2dc here = positionAt(look, time);
        Vector2dc there = positionAt(look, time + error);
        return here != null && there != null && here.distance(there) < SETTLED;
    }

    /** The time by the model of the shutter and the middle of the exposure, without the delay of a line. */
    private double timeWithoutDelay(Vector2dc position) {
        return time(position.x(), position.y()) - rolling.delay(line(position) + 0.5, lines());
    }

    /** As {@link #time}, but as if the lines of a rolling shutter had no width. */
    private double smoothTime(Vector2dc position) {
        double middle = Math.max(0.5, Math.min(lines() - 0.5, acrossLines(position)));
        return timeWithoutDelay(position) + rolling.delay(middle, lines());
    }

    /** The position for a shutter that opens a whole line together: at the time of the line in which it lies. */
    private Vector2dc ofOneLine(Function<Event, ? extends Vector3dc> look, double smooth) {
        Vector2dc near = positionAt(look, smooth);
        Vector2dc best = near;
        double least = Double.POSITIVE_INFINITY;
        for (int step = -1; step <= 1 && near != null; step++) {
            int line = Math.max(0, Math.min(lines() - 1, line(near) + step));
            Vector2dc position = near;
            for (int again = 0; again < LINE_STEPS && position != null; again++) {
                position = positionAt(look, timeWithoutDelay(position) + rolling.delay(line + 0.5, lines()));
            }
            double miss = position == null ? Double.NaN : Math.abs(acrossLines(position) - line - 0.5);
            if (miss < least) {
                least = miss;
                best = position;
            }
        }
        return best;
    }

    private int lines() {
        return rolling.direction().runsOverRows() ? view.height() : view.width();
    }

    private double acrossLines(Vector2dc position) {
        return rolling.direction().runsOverRows() ? position.y() - view.row() : position.x() - view.column();
    }

    private int line(Vector2dc position) {
        return (int) Math.max(0, Math.min(lines() - 1, Math.floor(acrossLines(position))));
    }

    /** The angle that one pixel covers at a position, in radians: the larger of width and height. */
    public double pixelAngle(double x, double y) {
        Vector3dc here = direction(x, y);
        return Math.max(
                Angles.between(here, Vectors.unit(direction(x + 1, y))),
                Angles.between(here, Vectors.unit(direction(x, y + 1))));
    }
}
