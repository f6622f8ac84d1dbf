package tompkins.ui.ray;

import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameMotion;
import tompkins.spacetime.SpaceTimeTransformation;
import tompkins.studio.RideLeg;
import tompkins.studio.RideMoment;
import tompkins.studio.Studio;
import tompkins.trace.Frame;
import tompkins.trace.SampleHistory;
import tompkins.ui.widget.Numbers;

/**
 * What a space-time (Minkowski) diagram of a ray or of a ride shows, in one of the frames: x is the place along the
 * camera's velocity or, if the camera is at rest, along the velocity of the object at which the ray ends; y is the
 * time. Both are measured from the event at which the ray starts at the lens, or the ride begins.
 *
 * @param frame the frame whose axes are upright
 * @param area what is shown
 * @param path the events of the main branch of the ray, from the lens on, backwards in time; or those of the ride
 * @param onwards how x and y change along the ray after its last event, to the background; null if it ends there
 * @param object how x and y change along the worldline of the object at the last event; null if there is none
 * @param light how x and y change along light that runs with the camera's velocity, and along light against it
 * @param lightThrough the events through which light is drawn
 * @param otherTime how x and y change along the time axis of the other frame: the worldline of what rests in it; null
 *     for a ride, in which that frame changes
 * @param otherSpace how x and y change along its axis of space: events that are simultaneous in it; null for a ride
 * @param simultaneous events that are simultaneous for a rider: from the rider to the place where the ride began
 * @param notes what is written beside events
 */
public record SpaceTimeDiagram(
        Frame frame,
        Rectangle2D area,
        List<Point2D> path,
        Point2D onwards,
        Point2D object,
        List<Point2D> light,
        List<Point2D> lightThrough,
        Point2D otherTime,
        Point2D otherSpace,
        List<Line2D> simultaneous,
        List<Note> notes) {

    /** The time that is shown after a ray reached the lens, as a share of the time that is shown before. */
    private static final double AFTER = 0.22;

    /** Room around the events of a ray, as a factor. */
    private static final double ROOM = 1.12;

    /** Room beside a ride for what is written there, and above and below it, as shares of the time that it takes. */
    private static final double BESIDE = 0.3;

    private static final double ABOVE = 0.06;

    /** Pieces of a leg of a ride. */
    private static final int PIECES = 24;

    /** Turns that are nearer than this share of a ride are one. */
    private static final double ONE_TURN = 1e-3;

    /** What is written beside an event. */
    record Note(Point2D event, String text) {}

    /** Marks what belongs to the camera. */
    static final String PRIME = "\u2032";

    /** The event at which the origins of both frames meet under every transformation. */
    private static final Event ZERO = new Event(0, 0, 0, 0);

    /** The diagram of a ray of a studio's picture. */
    static SpaceTimeDiagram of(SampleHistory life, Studio studio, Frame frame) {
        boolean ofScene = frame == Frame.SCENE;
        SpaceTimeTransformation sceneFromCamera = studio.sceneFromCamera();
        SpaceTimeTransformation fromOther = ofScene ? sceneFromCamera : sceneFromCamera.inverse();
        Vector3dc along = along(life.end(), studio);
        Event origin = ofScene ? sceneFromCamera.transform(life.cameraStart()) : life.cameraStart();
        List<Point2D> path = new ArrayList<>(List.of(new Point2D.Double()));
        for (SampleHistory.Encounter hit : life.mainHits()) {
            path.add(place(ofScene ? hit.inScene(sceneFromCamera) : hit.inCamera(sceneFromCamera), origin, along));
        }
        Point2D onwards = null;
        if (life.reachesBackground()) {
            Vector3dc direction = life.lastDirection();
            Event step = new Event(direction.x(), direction.y(), direction.z(), -life.lastSlowness());
            onwards = place(ofScene ? step : fromOther.transform(step), ZERO, along);
        }
        List<Point2D> light = Stream.of(along, along.negate(new Vector3d()))
                .map(way -> new Event(way.x(), way.y(), way.z(), 1))
                // it has the speed 1 in the camera frame under any law
                .map(step -> place(ofScene ? sceneFromCamera.transform(step) : step, ZERO, along))
                .toList();
        Event time = new Event(0, 0, 0, 1);
        Event space = new Event(along.x(), along.y(), along.z(), 0);
        return new SpaceTimeDiagram(
                frame,
                around(path),
                path,
                onwards,
                life.end() == null ? null : place(worldLine(life.end(), studio, frame), ZERO, along),
                light,
                List.of(path.get(0)),
                place(fromOther.transform(time), ZERO, along),
                place(fromOther.transform(space), ZERO, along),
                List.of(),
                List.of());
    }

    /**
     * The diagram of the ride of a studio in the scene frame: its worldline beside that of the place where it begins.
     * Where one leg follows another, light is drawn that the rider sees or sends, and what is simultaneous for the
     * rider before and after; the notes say when both meet the other worldline.
     */
    public static SpaceTimeDiagram ofRide(Studio studio) {
        List<RideMoment> moments = new ArrayList<>(List.of(RideMoment.start(studio)));
        List<RideMoment> ends = new ArrayList<>();
        for (RideLeg leg : studio.ride()) {
            RideMoment before = moments.get(moments.size() - 1);
            for (int i = 1; i <= PIECES; i++) {
                moments.add(before.after(leg, leg.properTime() * i / PIECES));
            }
            ends.add(moments.get(moments.size() - 1));
        }
        Event home = moments.get(0).rider().event();
        Vector3dc along = moments.stream()
                .map(moment -> moment.rider().event().position().sub(home.position()))
                .max(Comparator.comparingDouble(Vector3d::lengthSquared))
                .map(Vectors::unit)
                .orElseThrow();
        List<Point2D> path = moments.stream()
                .<Point2D>map(moment -> place(moment.rider().event(), home, along))
                .toList();
        double whole = path.get(path.size() - 1).getY();
        List<Point2D> turns = new ArrayList<>();
        List<Line2D> simultaneous = new ArrayList<>();
        List<Note> notes = new ArrayList<>();
        for (RideMoment end : ends) {
            Point2D here = place(end.rider().event(), home, along);
            boolean isNew = turns.isEmpty() || turns.get(turns.size() - 1).distance(here) > ONE_TURN * whole;
            if (isNew) {
                notes.add(new Note(here, "t" + PRIME + " = " + Numbers.brief(end.properTime())));
            }
            if (end == ends.get(ends.size() - 1)) {
                notes.add(at(whole));
                break;
            }
            Vector3d way = home.position().sub(end.rider().event().position());
            double now = here.getY() + end.rider().velocity().components().dot(way);
            simultaneous.add(new Line2D.Double(here, new Point2D.Double(0, now)));
            notes.add(at(now));
            if (isNew) {
                turns.add(here);
                notes.add(at(here.getY() - way.length()));
                notes.add(at(here.getY() + way.length()));
            }
        }
        Rectangle2D area = new Rectangle2D.Double();
        path.forEach(area::add);
        area.add(-BESIDE * whole, -ABOVE * whole);
        area.add(area.getMaxX() + BESIDE * whole / 2, (1 + ABOVE) * whole);
        List<Point2D> light = List.of(new Point2D.Double(1, 1), new Point2D.Double(-1, 1));
        return new SpaceTimeDiagram(Frame.SCENE, area, path, null, null, light, turns, null, null, simultaneous, notes);
    }

    /** Says the time of an event where a ride began. */
    private static Note at(double time) {
        return new Note(new Point2D.Double(0, time), "t = " + Numbers.brief(time));
    }

    /** The area around the path of a ray, with the event at the lens in the middle near the top. */
    static Rectangle2D around(List<Point2D> path) {
        // in x or y, whichever is more; 0 if there is nothing but the lens
        double reach = path.stream()
                .mapToDouble(point -> Math.max(Math.abs(point.getX()), Math.abs(point.getY())))
                .max()
                .orElse(0);
        double room = ROOM * (reach == 0 ? 1 : reach);
        return new Rectangle2D.Double(-room, -room, 2 * room, (1 + AFTER) * room);
    }

    /** The direction of x: that in which the camera flies, or else the object at which the ray ends. */
    private static Vector3dc along(SampleHistory.Encounter end, Studio studio) {
        if (studio.velocity().isRest() && end != null && end.movesByItself()) {
            Vector3d way = worldLine(end, studio, Frame.SCENE).position();
            // where a wheel touches the ground it rests for a moment
            if (way.lengthSquared() > 0) {
                return Vectors.unit(way);
            }
        }
        return Vectors.unit(studio.velocity().givenDirection());
    }

    /** How place and time in a frame change along the worldline of the point that was hit. */
    private static Event worldLine(SampleHistory.Encounter hit, Studio studio, Frame frame) {
        SpaceTimeTransformation sceneFromCamera = studio.sceneFromCamera();
        Vector3dc turning = hit.rest().velocity();
        Event own = turning == null ? new Event(0, 0, 0, 1) : new Event(turning.x(), turning.y(), turning.z(), 1);
        FrameMotion motion = hit.rest().motion();
        Event line =
                motion == null ? own : motion.toScene(studio.transformation()).difference(own);
        if (hit.frame() == frame) {
            return line;
        }
        return frame == Frame.SCENE
                ? sceneFromCamera.transform(line)
                : sceneFromCamera.inverse().transform(line);
    }

    private static Point2D place(Event event, Event origin, Vector3dc along) {
        return new Point2D.Double(along.dot(event.position().sub(origin.position())), event.time() - origin.time());
    }
}
