package tompkins.measure;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.joml.Vector2dc;
import tompkins.sceneobject.Plane;
import tompkins.studio.Studio;
import tompkins.trace.Frame;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;
import tompkins.world.FrameAppearance;

/**
 * Says where the objects of a scene are if its picture shows none of them: beside it, or behind the camera. Planes do
 * not count: they are floors and walls.
 */
public final class UnseenObjects {

    /** Rows, and columns, of the coarse picture. */
    private static final int TRIED = 16;

    /** The most objects that are named. */
    private static final int MOST_NAMED = 3;

    private final RenderPlan plan;
    private final Studio studio;
    private final List<Projection> eyes;

    /** The names of the objects that a coarse picture shows. */
    private final Set<String> seen;

    /** Looks at the coarse picture of a plan. */
    public UnseenObjects(RenderPlan plan) {
        this.plan = plan;
        studio = plan.studio();
        eyes = Projection.ofEyes(studio);
        seen = SampleHistory.hits(plan, TRIED)
                .filter(hit -> hit.frame() == Frame.SCENE && !(hit.object() instanceof Plane))
                .map(hit -> hit.object().description())
                .collect(Collectors.toSet());
    }

    /** The warning, without a full stop; none if a coarse picture shows an object, or there is none. */
    public Optional<String> warning() {
        return seen.isEmpty()
                ? missing().map(places -> "the picture shows no object, at most planes: " + places)
                : Optional.empty();
    }

    /** A sentence about the objects that a coarse picture does not show, if it shows others. */
    public Optional<String> sentence() {
        return seen.isEmpty()
                ? Optional.empty()
                : missing().map(places -> "Not all objects are in the picture: " + places + ".");
    }

    /** Where the first objects are that are not seen; nothing if others are in the picture, too small. */
    private Optional<String> missing() {
        List<SceneShapes.Thing> things = SceneShapes.of(plan.world().frames()).objects().stream()
                .filter(thing -> !seen.contains(thing.name()))
                .toList();
        List<SceneShapes.Thing> outside =
                things.stream().filter(thing -> !isInPicture(thing)).toList();
        if (outside.isEmpty() || seen.isEmpty() && outside.size() < things.size()) {
            return Optional.empty();
        }
        List<String> places = outside.stream()
                .map(this::told)
                .distinct()
                .limit(MOST_NAMED + 1)
                .toList();
        String others = places.size() > MOST_NAMED ? "; and others" : "";
        return Optional.of(places.stream().limit(MOST_NAMED).collect(Collectors.joining("; ")) + others);
    }

    /** Whether the middle of an object, or a corner of the box around it, lies in the picture, however small it is. */
    private boolean isInPicture(SceneShapes.Thing thing) {
        FrameAppearance frame = new FrameAppearance(studio, thing.motion());
        return Stream.concat(Stream.of(thing.middle()), Stream.of(thing.bounds().corners()))
                .anyMatch(point -> eyes.stream().anyMatch(eye -> eye.shows(eye.position(frame, point))));
    }

    private String told(SceneShapes.Thing thing) {
        FrameAppearance frame = new FrameAppearance(studio, thing.motion());
        Projection eye = eyes.get(0);
        return "\"" + thing.name() + "\" is " + side(eye, eye.position(frame, thing.middle()));
    }

    private static String side(Projection eye, Vector2dc position) {
        if (position == null) {
            return "behind the camera";
        }
        double right = (position.x() - eye.middle().x()) / eye.view().width();
        double down = (position.y() - eye.middle().y()) / eye.view().height();
        if (Math.abs(right) > Math.abs(down)) {
            return right < 0 ? "to the left of the picture" : "to the right of the picture";
        }
        return down < 0 ? "above the picture" : "below the picture";
    }
}
