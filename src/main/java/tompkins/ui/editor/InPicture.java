package tompkins.ui.editor;

import java.util.List;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.measure.Projection;
import tompkins.measure.SceneShapes;
import tompkins.measure.Sighting;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameMotion;
import tompkins.studio.ObjectShift;
import tompkins.studio.Studio;
import tompkins.studio.StudioPath;
import tompkins.studio.View;
import tompkins.trace.RenderPlan;
import tompkins.ui.widget.Numbers;
import tompkins.world.SeenFrame;

/** Finds out whether an object of the scene lies within the edges of the picture, and brings objects there. */
final class InPicture {

    /** An object is brought before what is seen, at this part of the distance to it. */
    private static final double BEFORE = 0.7;

    /** The farthest that an object is brought: where objects usually are. */
    private static final double FARTHEST = Sphere.DEFAULT.centre().length();

    /** To find out what is seen among more primitives takes too long. */
    private static final double MOST_PRIMITIVES = 100_000;

    private static final StudioPath FIRST = StudioPath.ROOT.then("scene").then(0);

    private InPicture() {}

    /**
     * Whether the middle of one part of an object lies in the picture, or of a part that has no middle; what hides it
     * does not count.
     */
    static boolean shows(Studio studio, SceneObject object) {
        SceneShapes shapes = alone(studio, object);
        Projection projection = Projection.of(studio);
        return shapes.objects().isEmpty()
                || shapes.objects().stream().anyMatch(part -> shows(projection, part.motion(), part.middle()));
    }

    private static boolean shows(Projection projection, FrameMotion motion, Vector3dc point) {
        return projection.shows(projection.position(new SeenFrame(projection.studio(), motion), point));
    }

    private static SceneShapes alone(Studio studio, SceneObject object) {
        return SceneShapes.of(
                RenderPlan.of(studio.withScene(List.of(object))).world().frames());
    }

    /**
     * An object, shifted to where the middle of the picture shows the middle of its first part, before what is seen
     * there; the object itself if it has no bounded part.
     */
    static SceneObject brought(Studio studio, SceneObject object) {
        List<SceneShapes.Thing> parts = alone(studio, object).objects();
        if (parts.isEmpty()) {
            return object;
        }
        FrameMotion motion = parts.get(0).motion();
        Vector3d middle = parts.get(0).middle();
        Event wanted = new SeenFrame(studio, motion).fromCamera(ahead(studio));
        Vector3d shift = ObjectShift.of(studio.withScene(List.of(object)), FIRST, FIRST, motion)
                .bringing(new Event(middle.x, middle.y, middle.z, wanted.time()), null, 0, wanted);
        return object.shifted(Numbers.rounded(shift, 3));
    }

    /** The event, in the camera frame, from which light for the middle of the picture comes. */
    private static Event ahead(Studio studio) {
        Projection projection = Projection.of(studio);
        double distance = Math.min(FARTHEST, BEFORE * distance(studio, projection.middle()));
        Vector3dc look = projection.direction(
                projection.middle().x(), projection.middle().y());
        Event lens = projection.lensEvent();
        double delay = studio.view() == View.MEASURED ? 0 : distance;
        return lens.plus(new Event(distance * look.x(), distance * look.y(), distance * look.z(), -delay));
    }

    /** How far away what is seen at a place is; infinite if nothing is, or if there is too much to find it. */
    private static double distance(Studio studio, Vector2dc place) {
        double primitives =
                studio.scene().stream().mapToDouble(SceneObject::primitiveCount).sum();
        Sighting seen = primitives > MOST_PRIMITIVES ? null : Sighting.of(RenderPlan.of(studio), place.x(), place.y());
        return seen == null || seen.hit() == null ? Double.POSITIVE_INFINITY : seen.cameraDistance();
    }
}
