package tompkins.sceneobject;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;
import org.joml.Matrix3d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.primitive.Bounds;
import tompkins.primitive.Placement;
import tompkins.primitive.Primitive;
import tompkins.primitive.RestFrame;
import tompkins.primitive.Rotation;
import tompkins.property.InvalidPropertyException;
import tompkins.property.NumberText;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameMotion;
import tompkins.spacetime.FrameTree;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;

/** Collects the primitives of a scene, a list for each velocity, numbered in the order of the scene file. */
public final class PrimitiveCollector {

    /** The sizes that always work: their fourth powers are far from the limits of a double. Others may work, too. */
    private static final String ALLOWED = "of a size that can be worked with (lengths from 1e-50 to 1e50 always can)";

    private static final String VELOCITY = "velocity";

    private final Function<Vector3dc, Event> imagePoints;
    private final FrameTree tree;

    /** The same frames, in the coordinates in which they are described. */
    private final FrameTree described;

    /** How each frame moves, null for the outermost, and what rests there. */
    private final List<FrameMotion> motions = new ArrayList<>();

    private final List<List<Primitive>> objects = new ArrayList<>();
    private int count;

    /** Whether sizes that are not numbers are refused: only if there is a place in a scene file to name. */
    private boolean checksSizes;

    // where what is added now belongs
    private int frame;
    private RestFrame rest;

    /**
     * A collector.
     *
     * @param imagePoints gives, for a point that is fixed to the camera, the event in the scene frame at which the ray
     *     through the centre of the lens photographs it
     * @param tree how coordinates change from frame to frame, and where those of each frame begin
     */
    public PrimitiveCollector(Function<Vector3dc, Event> imagePoints, FrameTree tree) {
        this.imagePoints = imagePoints;
        this.tree = tree;
        described = FrameTree.described(tree.law());
        frame = addFrame(null);
        rest = restFrame(Event.ORIGIN, 0);
    }

    /** What rests in the present frame, and is described from an event of it. */
    private RestFrame restFrame(Event zero, double clockOffset) {
        return new RestFrame(motions.get(frame), zero.minus(origin()), clockOffset, null);
    }

    /** A collector for objects at rest whose place does not depend on the camera; image points stay where they are. */
    public PrimitiveCollector() {
        this(point -> new Event(point.x(), point.y(), point.z(), 0), FrameTree.described(TransformationLaw.NONE));
    }

    /** Collects objects whose place does not depend on the camera; image points stay where they are. */
    public static List<Primitive> primitivesOf(SceneObject object) {
        PrimitiveCollector collector = new PrimitiveCollector();
        object.addTo(collector, Placement.NONE);
        return collector.primitives(0);
    }

    /** The refusal of something that is so large, small or far away that results are no longer numbers. */
    public static InvalidPropertyException refusal(String property, String value) {
        return new InvalidPropertyException(property, ALLOWED, value);
    }

    /**
     * Adds the primitives of a list of objects.
     *
     * @param name what scene files call the list
     * @throws InvalidPropertyException if an object is too large or too small to work with, or too fast, or if there
     *     are too many
     */
    public void add(String name, List<SceneObject> objects, Placement placement) {
        requireFewEnough(name, objects);
        for (int i = 0; i < objects.size(); i++) {
            add(name + "[" + i + "]", objects.get(i), placement);
        }
    }

    /** Counts before anything is made, because copies of copies could take forever. */
    private static void requireFewEnough(String name, List<SceneObject> objects) {
        double before = 0;
        for (int i = 0; i < objects.size(); i++) {
            SceneObject object = objects.get(i);
            double count = object.primitiveCount();
            if (before + count > SceneObject.MOST_PRIMITIVES) {
                throw new InvalidPropertyException(
                        name + "[" + i + "]",
                        "small enough for at most " + NumberText.of(SceneObject.MOST_PRIMITIVES) + " primitives in all",
                        '"' + object.description() + "\" with " + NumberText.of(count)
                                + (before == 0 ? "" : " (after " + NumberText.of(before) + ")"));
            }
            before += count;
        }
    }

    /**
     * Adds the primitives of an object.
     *
     * @param property what scene files call the place of the object
     * @throws InvalidPropertyException if the object is too large or too small to work with, or too fast
     */
    public void add(String property, SceneObject object, Placement placement) {
        checksSizes = true;
        try {
            object.addTo(this, placement);
        } catch (ArithmeticException beyondNumbers) {
            throw refused(property, object, beyondNumbers);
        } catch (InvalidPropertyException invalid) {
            throw invalid.property().equals(VELOCITY)
                    ? new InvalidPropertyException(property, invalid)
                    : refused(property, object, invalid);
        }
    }

    private static InvalidPropertyException refused(String property, SceneObject object, RuntimeException cause) {
        InvalidPropertyException refusal = refusal(property, '"' + object.description() + '"');
        refusal.initCause(cause);
        return refusal;
    }

    /** Adds one primitive after those that are there. */
    public void add(Primitive primitive) {
        // planes have no bounds
        Bounds bounds = checksSizes ? primitive.bounds() : null;
        if (bounds != null && !Double.isFinite(bounds.halfArea())) {
            throw new ArithmeticException("no size: " + bounds);
        }
        primitive.setOrder(count++);
        primitive.setRestFrame(rest);
        objects.get(frame).add(primitive);
    }

    /**
     * Adds what moves. Everything that moves with one velocity shares one frame.
     *
     * @param velocity velocity in the frame in which the placement places
     * @param place where the origin of what moves is at proper time 0, before the placement
     * @param offset what its clocks show then, beyond the offset of what it moves in
     * @param content adds what moves, placed as it is told
     * @throws InvalidPropertyException if motions together are too fast, or velocities too many
     */
    public void addMoving(
            Velocity velocity, Vector3dc place, double offset, Placement placement, Consumer<Placement> content) {
        int outerFrame = frame;
        RestFrame outerRest = rest;
        double clockOffset = rest.clockOffset() + offset;
        double ownZero = rest.properTimeZero().plus(origin()).time();
        Velocity turned = placement.velocity(velocity);
        if (tree.law() == TransformationLaw.NONE || turned.isRest()) {
            Vector3dc shift = placement.vector(place);
            rest = new RestFrame(
                    rest.motion(),
                    rest.properTimeZero().plus(new Event(shift.x(), shift.y(), shift.z(), 0)),
                    clockOffset,
                    null);
            content.accept(placement.after(new Placement(1, new Matrix3d(), place)));
        } else {
            Vector3d at = placement.place(place);
            Event start = new Event(at.x, at.y, at.z, ownZero);
            frame = frameFor(turned, start);
            Event shift =
                    described.route(motions.get(outerFrame), motions.get(frame)).transform(start);
            rest = restFrame(shift, clockOffset);
            content.accept(placement.inFrame(shift.position(), origin().position()));
        }
        frame = outerFrame;
        rest = outerRest;
    }

    /** Adds what turns in the frame in which it is added. */
    void addTurning(Rotation rotation, Runnable content) {
        RestFrame outer = rest;
        rest = rest.turning(rotation);
        content.run();
        rest = outer;
    }

    /** The law by which what moves is seen. */
    TransformationLaw law() {
        return tree.law();
    }

    /** The time that is described as 0, in the coordinates in which the tracer works. */
    double zeroTime() {
        return rest.properTimeZero().time();
    }

    private Event origin() {
        return tree.origin(motions.get(frame));
    }

    private int frameFor(Velocity velocity, Event start) {
        for (int i = 0; i < motions.size(); i++) {
            FrameMotion motion = motions.get(i);
            if (motion != null
                    && motion.outer() == motions.get(frame)
                    && motion.velocity().proper().equals(velocity.proper())) {
                return i;
            }
        }
        if (motions.size() > Moving.MOST_FRAMES) {
            throw new InvalidPropertyException(
                    VELOCITY, "one of at most " + Moving.MOST_FRAMES + " in a scene", velocity.toString());
        }
        FrameMotion motion = new FrameMotion(motions.get(frame), velocity, start);
        if (tree.law() == TransformationLaw.LORENTZ) {
            motion.requireGamma(VELOCITY);
        }
        return addFrame(motion);
    }

    private int addFrame(FrameMotion motion) {
        motions.add(motion);
        objects.add(new ArrayList<>());
        return motions.size() - 1;
    }

    /**
     * Where a point that is fixed to the camera is photographed, in the coordinates in which what is added now is
     * described.
     */
    Vector3dc imagePoint(Vector3dc point) {
        Event event = described.route(null, motions.get(frame)).transform(imagePoints.apply(point));
        return event.minus(rest.properTimeZero().plus(origin())).position();
    }

    /** The number of the frame in which what is added now rests. */
    public int frame() {
        return frame;
    }

    /** Where and when what is added now is described. */
    public RestFrame rest() {
        return rest;
    }

    /** How each frame moves, so far, by its number; null is the first, in which rests what does not move. */
    public List<FrameMotion> motions() {
        return Collections.unmodifiableList(motions);
    }

    /** What rests in a frame, so far. */
    public List<Primitive> primitives(int index) {
        return Collections.unmodifiableList(objects.get(index));
    }
}
