package tompkins.ui.ray;

import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameMotion;
import tompkins.spacetime.SpaceTimeTransformation;
import tompkins.studio.Studio;
import tompkins.trace.Frame;
import tompkins.trace.RayLife;

/**
 * What a space-time (Minkowski) diagram of a ray shows, in one of the frames: x is the place along the camera's
 * velocity or, if the camera is at rest, along the velocity of the object at which the ray ends; y is the time. Both
 * are measured from the event at which the ray starts at the lens.
 *
 * @param frame the frame whose axes are upright
 * @param path the events of the main branch of the ray, from the lens on, backwards in time
 * @param onwards how x and y change along the ray after its last event, to the background; null if it ends there
 * @param object how x and y change along the worldline of the object at the last event; null if there is none
 * @param light how x and y change along light that runs with the camera's velocity, and along light against it
 * @param otherTime how x and y change along the time axis of the other frame: the worldline of what rests in it
 * @param otherSpace how x and y change along its axis of space: events that are simultaneous in it
 */
public record SpaceTimeDiagram(
        Frame frame,
        List<Point2D> path,
        Point2D onwards,
        Point2D object,
        List<Point2D> light,
        Point2D otherTime,
        Point2D otherSpace) {

    /** The event at which the origins of both frames meet under every transformation. */
    private static final Event ZERO = new Event(0, 0, 0, 0);

    /** The diagram of a ray of a studio's picture. */
    static SpaceTimeDiagram of(RayLife life, Studio studio, Frame frame) {
        boolean ofScene = frame == Frame.SCENE;
        SpaceTimeTransformation sceneFromCamera = studio.sceneFromCamera();
        SpaceTimeTransformation fromOther = ofScene ? sceneFromCamera : sceneFromCamera.inverse();
        Vector3dc along = along(life.end(), studio);
        Event origin = ofScene ? sceneFromCamera.transform(life.cameraStart()) : life.cameraStart();
        List<Point2D> path = new ArrayList<>(List.of(new Point2D.Double()));
        for (RayLife.Encounter hit : life.mainHits()) {
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
                path,
                onwards,
                life.end() == null ? null : place(worldLine(life.end(), studio, frame), ZERO, along),
                light,
                place(fromOther.transform(time), ZERO, along),
                place(fromOther.transform(space), ZERO, along));
    }

    /** The direction of x: that in which the camera flies, or else the object at which the ray ends. */
    private static Vector3dc along(RayLife.Encounter end, Studio studio) {
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
    private static Event worldLine(RayLife.Encounter hit, Studio studio, Frame frame) {
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

    /** How far from the lens the events are, in x or y, whichever is more; 0 if there is nothing but the lens. */
    public double reach() {
        return path.stream()
                .mapToDouble(point -> Math.max(Math.abs(point.getX()), Math.abs(point.getY())))
                .max()
                .orElse(0);
    }
}
