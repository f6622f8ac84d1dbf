package tompkins.measure;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.light.PointLight;
import tompkins.math.Vectors;
import tompkins.property.Descriptions;
import tompkins.sceneobject.ImagePointGrid;
import tompkins.sceneobject.Placed;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameMotion;
import tompkins.spacetime.FrameRoute;
import tompkins.spacetime.FrameTree;
import tompkins.studio.ObjectShift;
import tompkins.studio.Studio;
import tompkins.studio.StudioPath;
import tompkins.trace.Frame;
import tompkins.trace.RayLife;
import tompkins.trace.RenderPlan;

/**
 * A point of an object, or a lamp, held where a picture shows it: says where the object must be so that the point is
 * seen at another place of the picture. In the frame in which it rests, the point moves in the plane through it across
 * the ray by which it was seen at first. It must be seen directly in its frame, neither in a mirror nor through glass;
 * windows that move with the camera may stand before it.
 */
public final class Grip {

    /** A ray that meets the plane more obliquely than this, by the cosine, brings the point nowhere. */
    private static final double OBLIQUE = 0.05;

    /** Shifts are rounded to decimals that move the point by less than this, in pixels. */
    private static final double ROUNDING = 0.1;

    /** A plane that moves along itself, but for this part of the way, stays the same plane to a person. */
    private static final double ALONG = 0.1;

    /** Events on a ray: where it starts in a frame, and a step along it. */
    private record Line(Event start, Event step) {}

    /**
     * What is held.
     *
     * @param frame the frame in which it is seen
     * @param motion how the frame moves in which it rests; null for the one in which it is seen
     * @param event where it is, in the frame in which it rests
     * @param velocity how it turns there about an axis that rests; null if it does not turn
     * @param ownTime what its own clock has counted
     */
    private record Point(Frame frame, FrameMotion motion, Event event, Vector3dc velocity, double ownTime) {}

    private final RenderPlan plan;
    private final StudioPath path;
    private final Object object;
    private final Point held;
    private final ObjectShift shift;

    /** From the frame in which the point is seen to the one in which it rests. */
    private final FrameRoute toRest;

    /** Unit normal of the plane; null if no ray can be found again. */
    private final Vector3dc across;

    /** The decimals of a shift; below 0 for tens, hundreds, and so on. */
    private final int decimals;

    private Grip(RenderPlan plan, Sighting seen, StudioPath path, StudioPath part, Point held) {
        this.plan = plan;
        this.path = path;
        this.held = held;
        object = path.get(plan.studio());
        shift = ObjectShift.of(plan.studio(), path, part, held.motion);
        toRest = toRest(plan, held.motion);
        across = Vectors.unit(line(seen.life()).step().position());
        decimals = decimals(seen.x(), seen.y());
    }

    private static FrameRoute toRest(RenderPlan plan, FrameMotion motion) {
        return FrameTree.described(plan.studio().transformation()).route(null, motion);
    }

    /**
     * Holds what a picture shows at a place.
     *
     * @param plan the picture
     * @param seen what is seen there
     * @param chosen the way to the object that is to be moved, if what is seen is a part of it; otherwise that moves
     *     alone. If it has no place of its own, and is {@link Placed}, its place is changed
     * @return empty if nothing is there, if it is not seen directly, or if the camera says where it is
     */
    public static Optional<Grip> of(RenderPlan plan, Sighting seen, StudioPath chosen) {
        if (seen.life() == null) {
            return Optional.empty();
        }
        List<RayLife.Encounter> first = Stream.of(Frame.CAMERA, Frame.SCENE)
                .flatMap(frame -> seen.life().mainHits().stream()
                        .filter(hit -> hit.frame() == frame)
                        .limit(1))
                .toList();
        for (RayLife.Encounter hit : first) {
            Optional<StudioPath> part = way(plan, hit);
            if (part.isPresent() && part.get().isWithin(chosen) && chosen.get(plan.studio()) instanceof SceneObject) {
                return of(plan, seen, hit, placing(plan.studio(), chosen), part.get());
            }
        }
        return Optional.ofNullable(seen.hit())
                .filter(first::contains)
                .flatMap(hit ->
                        way(plan, hit).flatMap(part -> of(plan, seen, hit, placing(plan.studio(), part), part)));
    }

    /** The way to what says where an object is: a mesh has no place of its own, and what places it is moved. */
    private static StudioPath placing(Studio studio, StudioPath object) {
        boolean placed = object.parent().get(studio) instanceof Placed
                && Descriptions.places(object.get(studio).getClass()).isEmpty();
        return placed ? object.parent() : object;
    }

    /** Holds a lamp; empty if what moves with the camera hides it. */
    public static Optional<Grip> of(RenderPlan plan, SeenLamp lamp) {
        Vector3dc point = lamp.point();
        Point held = new Point(Frame.SCENE, lamp.motion(), new Event(point.x(), point.y(), point.z(), 0), null, 0);
        return Optional.of(Sighting.of(plan, lamp.place().x(), lamp.place().y()))
                .filter(seen -> seen.sceneDirection() != null)
                .map(seen -> new Grip(plan, seen, lamp.path(), lamp.path(), held));
    }

    private static Optional<StudioPath> way(RenderPlan plan, RayLife.Encounter hit) {
        return StudioPath.to(plan.studio(), hit.object());
    }

    private static Optional<Grip> of(
            RenderPlan plan, Sighting seen, RayLife.Encounter hit, StudioPath path, StudioPath part) {
        RayLife.Rest rest = hit.rest();
        Point held = new Point(
                hit.frame(),
                rest.motion(),
                toRest(plan, rest.motion()).transform(hit.event()),
                rest.velocity(),
                rest.event().time());
        return path.get(plan.studio()) instanceof ImagePointGrid
                ? Optional.empty()
                : Optional.of(new Grip(plan, seen, path, part, held));
    }

    /** The way to the object or lamp that moves. */
    public StudioPath path() {
        return path;
    }

    /** The ray of a place, in the frame in which the point rests; null if none comes so far. */
    private Line line(RayLife life) {
        if (life == null || held.frame == Frame.SCENE && life.sceneStart() == null) {
            return null;
        }
        return held.frame == Frame.CAMERA
                ? new Line(life.cameraStart(), step(life.cameraDirection(), 1))
                : new Line(
                        toRest.transform(life.sceneStart()),
                        toRest.difference(step(life.sceneDirection(), life.sceneSlowness())));
    }

    private static Event step(Vector3dc direction, double slowness) {
        return new Event(direction.x(), direction.y(), direction.z(), -slowness);
    }

    /** Where and when the ray of a place meets the plane; null if it does not. */
    private Event wanted(double x, double y) {
        Line line = line(RayLife.of(plan, x, y, 0, 0));
        if (line == null) {
            return null;
        }
        Vector3d step = line.step().position();
        double slope = step.dot(across);
        double steps = held.event.minus(line.start()).position().dot(across) / slope;
        return slope > OBLIQUE * step.length() && steps > 0
                ? new Event(
                        line.start().x() + steps * step.x,
                        line.start().y() + steps * step.y,
                        line.start().z() + steps * step.z,
                        line.start().time() + steps * line.step().time())
                : null;
    }

    private int decimals(double x, double y) {
        double pixel = Stream.of(wanted(x + 1, y), wanted(x, y + 1))
                .filter(event -> event != null)
                .mapToDouble(event -> event.minus(held.event).position().length())
                .min()
                .orElse(0);
        double finest = ROUNDING * pixel / shift.longestWay();
        return finest > 0 ? (int) Math.ceil(-Math.log10(finest)) : Integer.MAX_VALUE;
    }

    /**
     * The object or lamp where its point is seen at another place of the picture, in pixels; empty if the ray of that
     * place does not lead there.
     */
    public Optional<Object> at(double x, double y) {
        Event wanted = wanted(x, y);
        if (wanted == null) {
            return Optional.empty();
        }
        Vector3d by = shift.bringing(held.event, held.velocity, held.ownTime, wanted);
        return by.isFinite()
                ? Optional.of(shifted(new Vector3d(rounded(by.x), rounded(by.y), rounded(by.z))))
                : Optional.empty();
    }

    private Object shifted(Vector3dc by) {
        return object instanceof PointLight lamp ? lamp.shifted(by) : ((SceneObject) object).shifted(by);
    }

    private double rounded(double value) {
        return decimals == Integer.MAX_VALUE
                ? value
                : BigDecimal.valueOf(value)
                        .setScale(decimals, RoundingMode.HALF_EVEN)
                        .doubleValue();
    }

    /** Whether the picture does not tell the object from what it was: a plane without a pattern, moved along itself. */
    public boolean leavesAlike(Object moved) {
        if (!(object instanceof Plane before)
                || !(moved instanceof Plane after)
                || before.surface().usesCoordinates()) {
            return false;
        }
        Vector3d way = after.point().sub(before.point(), new Vector3d());
        return Math.abs(way.dot(Vectors.unit(before.normal()))) < ALONG * way.length();
    }
}
