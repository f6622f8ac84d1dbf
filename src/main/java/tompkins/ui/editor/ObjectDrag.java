package tompkins.ui.editor;

import java.awt.geom.Point2D;
import java.util.Optional;
import tompkins.measure.Grip;
import tompkins.measure.Sighting;
import tompkins.sceneobject.SceneObject;
import tompkins.studio.Studio;
import tompkins.studio.StudioPath;
import tompkins.trace.RenderPlan;

/**
 * One drag of an object in the picture: its rays, which are followed by a thread of its own. All changes of a drag
 * belong to one gesture, which is this.
 */
final class ObjectDrag {

    /**
     * What is known when a ray has been followed.
     *
     * @param drag the drag
     * @param place where the pointer was, in pixels of the picture
     * @param grip what is held; empty if nothing is
     * @param refusal the key of the text that says why nothing is held, or why nothing moves; empty if something does
     * @param moved the object where it belongs now; empty if the ray leads nowhere
     */
    record Answer(ObjectDrag drag, Point2D place, Optional<Grip> grip, String refusal, Optional<SceneObject> moved) {}

    /** The refusal of what has no place. */
    static final String SKY = "drag.sky";

    private final Studio studio;
    private final RenderPlan shown;
    private final Point2D from;
    private final StudioPath chosen;
    private Sighting seen;
    private Optional<Grip> grip = Optional.empty();

    /**
     * A drag in the picture of a studio.
     *
     * @param shown the picture on the screen, which may be one of a little while before
     * @param from where it begins, in pixels of the picture
     * @param chosen the way to what is chosen in the editor
     */
    ObjectDrag(Studio studio, RenderPlan shown, Point2D from, StudioPath chosen) {
        this.studio = studio;
        this.shown = shown;
        this.from = from;
        this.chosen = chosen;
    }

    /** Where the object belongs while the pointer is at a place of the picture; called by one thread. */
    Answer to(Point2D place) {
        if (seen == null) {
            RenderPlan plan = RenderPlan.of(
                    studio.withSettings(studio.settings().withSize(shown.width(), shown.height())), shown);
            seen = Sighting.of(plan, from.getX(), from.getY());
            grip = Grip.of(plan, seen, chosen);
        }
        Optional<SceneObject> moved = grip.flatMap(held -> held.at(place.getX(), place.getY()));
        return new Answer(this, place, grip, refusal(moved), moved);
    }

    private String refusal(Optional<SceneObject> moved) {
        if (grip.isEmpty()) {
            return seen.hit() == null ? SKY : "drag.indirect";
        }
        return moved.filter(grip.get()::leavesAlike).isPresent() ? "drag.plain" : "";
    }
}
