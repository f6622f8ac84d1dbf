package tompkins.ui.editor;

import java.util.ArrayList;
import java.util.List;
import org.joml.Matrix3d;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.measure.Projection;
import tompkins.measure.SceneShapes;
import tompkins.measure.Sighting;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameMotion;
import tompkins.spacetime.FrameRoute;
import tompkins.spacetime.FrameTree;
import tompkins.studio.Studio;
import tompkins.studio.View;
import tompkins.trace.RenderPlan;
import tompkins.ui.widget.Numbers;
import tompkins.world.FrameAppearance;

/** Finds out whether an object of the scene lies within the edges of the picture, and brings objects there. */
final class InPicture {

    /** An object is brought before what is seen, at this part of the distance to it. */
    private static final double BEFORE = 0.7;

    /** The farthest that an object is brought: where objects usually are. */
    private static final double FARTHEST = Sphere.DEFAULT.centre().length();

    /** So many points across and down are looked at, to find out how much of the picture an object takes. */
    private static final int GRID = 16;

    /** What takes no more of the picture than this is hardly seen. */
    private static final double LEAST = 1.5 / (GRID * GRID);

    /** An object that is brought takes no more of the picture than this. */
    private static final double MOST = 0.5;

    /** Where objects are brought, one after the other: shares of the width, from the middle. */
    private static final double[] PLACES = {0, 0.2, -0.2, 0.35, -0.35};

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
        return projection.shows(projection.position(new FrameAppearance(projection.studio(), motion), point));
    }

    private static SceneShapes alone(Studio studio, SceneObject object) {
        return SceneShapes.of(
                RenderPlan.of(studio.withScene(List.of(object))).world().frames());
    }

    /**
     * An object that is added to a studio, where its picture shows it: where it is, or else before what is seen in the
     * middle or beside it, apart from other things if there is room. What moves may leave its place at once, and is
     * always brought. Other things stay where they are if they have no bounded part, or would hide all else, or lie
     * outside and would lie in each other.
     */
    static SceneObject inSight(Studio studio, SceneObject object) {
        if (NewObject.areTooMany(studio.scene())) {
            return shows(studio, object) ? object : brought(studio, object, 0);
        }
        boolean leaves = object instanceof Moving;
        boolean isInside = shows(studio, object);
        RenderPlan before = RenderPlan.of(studio);
        if (!leaves && isInside && part(before, object) > LEAST) {
            return object;
        }
        SceneObject crowded = leaves ? brought(studio, object, 0) : object;
        for (double aside : PLACES) {
            SceneObject there = brought(studio, object, aside);
            double part = part(before, there);
            if (part > 0 && part <= MOST) {
                if (leaves || NewObject.isFree(there, studio.scene())) {
                    return there;
                }
                crowded = isInside && crowded == object ? there : crowded;
            }
        }
        return crowded;
    }

    /** Whether a studio with another object has another picture. */
    static boolean isSeen(Studio studio, SceneObject object) {
        return part(RenderPlan.of(studio), object) > 0;
    }

    /** How much of the picture of a plan another object changes, from 0 to 1. */
    private static double part(RenderPlan before, SceneObject object) {
        Studio studio = before.studio();
        List<SceneObject> longer = new ArrayList<>(studio.scene());
        longer.add(object);
        RenderPlan after = RenderPlan.of(studio.withScene(longer));
        Projection projection = Projection.of(studio);
        double changed = alone(studio, object).objects().stream()
                        .map(part -> projection.position(new FrameAppearance(studio, part.motion()), part.middle()))
                        .filter(projection::shows)
                        .anyMatch(middle -> differ(before, after, middle.x(), middle.y()))
                ? 1
                : 0;
        for (int i = 0; i < GRID * GRID; i++) {
            double x = (i % GRID + 0.5) * before.width() / GRID;
            double y = (i / GRID + 0.5) * before.height() / GRID;
            changed += differ(before, after, x, y) ? 1 : 0;
        }
        return changed / (GRID * GRID + 1);
    }

    private static boolean differ(RenderPlan before, RenderPlan after, double x, double y) {
        Sighting first = Sighting.of(before, x, y);
        Sighting second = Sighting.of(after, x, y);
        // parts of two objects may have the same description
        return second.hit() != null
                && (first.hit() == null
                        || !second.hit().object().equals(first.hit().object())
                        || second.cameraDistance() != first.cameraDistance());
    }

    /**
     * An object, shifted to where a place of the picture shows the middle of its first part, before what is seen there;
     * the object itself if it has no bounded part.
     *
     * @param aside how far the place is from the middle, as a share of the width
     */
    private static SceneObject brought(Studio studio, SceneObject object, double aside) {
        List<SceneShapes.Thing> parts = alone(studio, object).objects();
        if (parts.isEmpty()) {
            return object;
        }
        FrameMotion motion = parts.get(0).motion();
        Vector3d middle = parts.get(0).middle();
        Vector3d wanted = new FrameAppearance(studio, motion)
                .fromCamera(ahead(studio, aside))
                .position();
        // a shift in the scene moves what rests in another frame by another way, linearly
        FrameRoute fromScene = FrameTree.described(studio.transformation()).route(null, motion);
        Vector3d shift = new Matrix3d(
                        fromScene.difference(new Event(1, 0, 0, 0)).position(),
                        fromScene.difference(new Event(0, 1, 0, 0)).position(),
                        fromScene.difference(new Event(0, 0, 1, 0)).position())
                .invert()
                .transform(wanted.sub(middle));
        return object.shifted(Numbers.rounded(shift, 3));
    }

    /** The event, in the camera frame, from which light for a place of the picture comes. */
    private static Event ahead(Studio studio, double aside) {
        Projection projection = Projection.of(studio);
        Vector2dc middle = projection.middle();
        Vector2dc place = new Vector2d(middle.x() + aside * studio.settings().width(), middle.y());
        double distance = Math.min(FARTHEST, BEFORE * distance(studio, place));
        Vector3dc look = projection.direction(place.x(), place.y());
        Event lens = projection.lensEvent();
        double delay = studio.view() == View.MEASURED ? 0 : distance;
        return lens.plus(new Event(distance * look.x(), distance * look.y(), distance * look.z(), -delay));
    }

    /** The distance of what is seen at a place; infinite if nothing is, or if there is too much to search. */
    private static double distance(Studio studio, Vector2dc place) {
        Sighting seen =
                NewObject.areTooMany(studio.scene()) ? null : Sighting.of(RenderPlan.of(studio), place.x(), place.y());
        return seen == null || seen.hit() == null ? Double.POSITIVE_INFINITY : seen.cameraDistance();
    }
}
