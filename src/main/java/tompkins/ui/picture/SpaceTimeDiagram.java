package tompkins.ui.picture;

import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.spacetime.Event;
import tompkins.spacetime.SpaceTimeTransformation;
import tompkins.studio.Studio;
import tompkins.trace.RayLife;

/**
 * What a space-time (Minkowski) diagram of a ray shows, in the scene frame: x is the place along the camera's velocity,
 * y the time, both counted from the event at which the ray starts at the lens.
 *
 * @param path the events of the main branch of the ray, from the lens on, backwards in time
 * @param onwards how x and y change along the ray after its last event, to the background; null if it ends there
 * @param cameraTime how x and y change along the camera's own time axis: the way of the camera
 * @param cameraSpace how x and y change along its axis of space: events that are simultaneous for the camera
 */
public record SpaceTimeDiagram(List<Point2D> path, Point2D onwards, Point2D cameraTime, Point2D cameraSpace) {

    /** Where the origins of both frames meet, whatever the transformation. */
    private static final Event ZERO = new Event(0, 0, 0, 0);

    /** The diagram of a ray of a studio's picture. */
    static SpaceTimeDiagram of(RayLife life, Studio studio) {
        SpaceTimeTransformation sceneFromCamera = studio.sceneFromCamera();
        Vector3dc along = new Vector3d(studio.velocity().givenDirection()).normalize();
        Event origin = sceneFromCamera.transform(life.cameraStart());
        List<Point2D> path = new ArrayList<>(List.of(new Point2D.Double()));
        for (RayLife.Encounter hit : life.mainHits()) {
            path.add(place(hit.inScene(sceneFromCamera), origin, along));
        }
        Point2D onwards = life.reachesBackground() ? new Point2D.Double(along.dot(life.lastDirection()), -1) : null;
        return new SpaceTimeDiagram(
                path,
                onwards,
                place(sceneFromCamera.transform(new Event(0, 0, 0, 1)), ZERO, along),
                place(sceneFromCamera.transform(new Event(along.x(), along.y(), along.z(), 0)), ZERO, along));
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
