package tompkins.ui.editor;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.Point2D;
import java.util.Optional;
import tompkins.measure.Grip;
import tompkins.measure.SeenLamp;
import tompkins.measure.Sighting;
import tompkins.studio.Studio;
import tompkins.studio.StudioPath;
import tompkins.trace.RenderPlan;

/**
 * One drag of an object or a lamp in the picture: where the pointer is, and its rays, which are followed by a thread of
 * their own. All changes of a drag belong to one gesture, which is this.
 */
final class ObjectDrag {

    /**
     * What is known when a ray has been followed.
     *
     * @param place where the pointer was, in pixels of the picture
     * @param grip what is held; empty if nothing is
     * @param refusal the key of the text that says why nothing is held, or why nothing moves; empty if something does
     * @param moved the object where it belongs now; empty if the ray leads nowhere
     */
    record Answer(Point2D place, Optional<Grip> grip, String refusal, Optional<Object> moved) {}

    /** The refusal of what has no place. */
    static final String SKY = "drag.sky";

    private final Studio studio;
    private final RenderPlan shown;
    private final Rectangle bounds;
    private final Point2D from;
    private final StudioPath chosen;

    /** The studio as it is unless somebody else changes it; for the event thread, as all until the sighting. */
    Studio held;

    boolean begun;
    boolean released;

    /** Where the pointer was last; null before it has moved. */
    private Point2D pointer;

    private Sighting seen;
    private Optional<Grip> grip = Optional.empty();

    /**
     * A drag in the picture of a studio.
     *
     * @param shown the picture on the screen, which may be one of a little while before
     * @param bounds where that lies on the canvas
     * @param from where it begins, a point of the canvas
     * @param chosen the way to what is chosen in the editor
     */
    ObjectDrag(Studio studio, RenderPlan shown, Rectangle bounds, Point from, StudioPath chosen) {
        this.studio = studio;
        this.shown = shown;
        this.bounds = bounds;
        this.from = place(from);
        this.chosen = chosen;
        held = studio;
    }

    /** The place of the picture at a point of the canvas, in its pixels; beside the picture, at its edge. */
    private Point2D place(Point point) {
        double x = (point.x + 0.5 - bounds.x) / bounds.width * shown.width();
        double y = (point.y + 0.5 - bounds.y) / bounds.height * shown.height();
        return new Point2D.Double(Math.max(0, Math.min(shown.width(), x)), Math.max(0, Math.min(shown.height(), y)));
    }

    /** Where it begins, in pixels of the picture. */
    Point2D from() {
        return from;
    }

    /** Moves the pointer; says where that is now, in pixels of the picture. */
    Point2D moveTo(Point point) {
        pointer = place(point);
        return pointer;
    }

    /** Whether the pointer has moved; until then it may be a click. */
    boolean hasMoved() {
        return pointer != null;
    }

    /** Whether the button was let go where an answer is for. */
    boolean endsWith(Answer answer) {
        return released && answer.place == pointer;
    }

    /** Where the object belongs while the pointer is at a place of the picture; called by one thread. */
    Answer to(Point2D place) {
        if (seen == null) {
            RenderPlan plan = RenderPlan.of(
                    studio.withSettings(studio.settings().withSize(shown.width(), shown.height())), shown);
            seen = Sighting.of(plan, from.getX(), from.getY());
            grip = SeenLamp.near(plan, from.getX(), from.getY())
                    .flatMap(lamp -> Grip.of(plan, lamp))
                    .or(() -> Grip.of(plan, seen, chosen));
        }
        Optional<Object> moved = grip.flatMap(held -> held.at(place.getX(), place.getY()));
        return new Answer(place, grip, refusal(moved), moved);
    }

    private String refusal(Optional<Object> moved) {
        if (grip.isEmpty()) {
            return seen.hit() == null ? SKY : "drag.indirect";
        }
        return moved.filter(grip.get()::leavesAlike).isPresent() ? "drag.plain" : "";
    }
}
