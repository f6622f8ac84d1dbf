package tompkins.world;

import java.util.function.DoubleFunction;
import org.hipparchus.analysis.UnivariateFunction;
import org.hipparchus.analysis.solvers.IllinoisSolver;
import org.hipparchus.exception.MathRuntimeException;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;
import tompkins.ray.Ray;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameMotion;
import tompkins.spacetime.FrameRoute;
import tompkins.spacetime.FrameTree;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.studio.View;

/**
 * How the camera sees what rests in one frame of the scene. An object at rest in the frame is seen along a direction of
 * that frame, from the event at which its light crosses the lens; so only directions have to be computed. A direction n
 * that is followed backwards in time has the tangent (n, -1), which the change of frame takes to the camera. In the
 * measured view the tangent lies in one time of the camera. In a Galilean world light has speed 1 in the camera frame,
 * and the tangent is (k n, -1) with the k that gives this speed.
 */
public final class FrameAppearance {

    /** A time counts as found if it is off by less than this part of the way. */
    private static final double SETTLED = 1e-9;

    private static final int MOST_STEPS = 60;

    private final TransformationLaw law;
    private final View view;

    /** The way from the camera frame to this one. */
    private final FrameRoute inwards;

    /** The way to the frame of the camera that sees. */
    private final FrameRoute outwards;

    /** The frame of a motion, in the view of the studio; null means the scene frame. */
    public FrameAppearance(Studio studio, FrameMotion motion) {
        this(studio, motion, studio.velocity());
    }

    private FrameAppearance(Studio studio, FrameMotion motion, Velocity observer) {
        view = studio.view();
        law = studio.transformation();
        FrameTree camera = FrameTree.described(law, studio.velocity());
        inwards = camera.route(camera.camera(), motion);
        FrameTree seeing = FrameTree.described(law, observer);
        outwards = seeing.route(motion, seeing.camera());
    }

    /** How a camera at rest in the scene sees the frame of a motion, or the scene frame if that is null. */
    public static FrameAppearance atRest(Studio studio, FrameMotion motion) {
        return new FrameAppearance(studio, motion, Velocity.REST);
    }

    /** An event of the camera frame, in this frame. */
    public Event fromCamera(Event event) {
        return inwards.transform(event);
    }

    /**
     * The direction in which the camera looks to see along a direction of this frame.
     *
     * @param direction of any length but 0
     * @return a unit vector in the camera frame, or null where that is not one direction: in a Galilean world whose
     *     camera is faster than light in this frame
     */
    public Vector3d look(Vector3dc direction) {
        Vector3d unit = Vectors.unit(direction);
        if (view == View.MEASURED) {
            return measured(unit);
        }
        if (law == TransformationLaw.GALILEAN) {
            return withLightOfTheCamera(unit);
        }
        Ray seen = inCamera(unit);
        return new Vector3d(seen.dx, seen.dy, seen.dz);
    }

    /**
     * The event, in this frame, at which a point that rests in it is seen: its light, which leaves there, crosses the
     * lens at an event of the camera frame. In the measured view both events have one time in the camera frame.
     *
     * @return null if no such light reaches the lens: in a Galilean world whose camera is faster than it
     */
    public Event seen(Vector3dc point, Event lensInCamera) {
        Event lens = inwards.transform(lensInCamera);
        Vector3d way = point.sub(lens.position(), new Vector3d());
        double earlier = view == View.MEASURED
                ? outwards.difference(new Event(way.x, way.y, way.z, 0)).time()
                        / outwards.worldLine().time()
                : law == TransformationLaw.GALILEAN ? withLightOfTheCamera(way, way.length()) : way.length();
        return Double.isNaN(earlier) ? null : new Event(point.x(), point.y(), point.z(), lens.time() - earlier);
    }

    /**
     * The event, in this frame, at which something is seen that runs there: light leaves its place at the time at which
     * it is there.
     *
     * @param path where it is at a time, slower than light
     * @param middle a point
     * @param reach how far it is from there at most
     * @return null if no such light reaches the lens
     */
    public Event seen(DoubleFunction<Vector3d> path, Vector3dc middle, double reach, Event lensInCamera) {
        Event around = seen(middle, lensInCamera);
        if (around == null || reach == 0) {
            return around;
        }
        UnivariateFunction late = time -> {
            Event light = seen(path.apply(time), lensInCamera);
            return light == null ? Double.NaN : time - light.time();
        };
        double first = bound(late, around.time(), -reach);
        double last = bound(late, around.time(), reach);
        try {
            double time = new IllinoisSolver(0, 0, SETTLED * reach).solve(MOST_STEPS, late, first, last);
            return seen(path.apply(time), lensInCamera);
        } catch (MathRuntimeException notFound) {
            return null;
        }
    }

    /** A time so far on one side that the difference has its sign; the light of the camera can be slow. */
    private static double bound(UnivariateFunction late, double time, double side) {
        double step = side;
        for (int i = 0; i < MOST_STEPS && !(late.value(time + step) * side > 0); i++) {
            step *= 2;
        }
        return time + step;
    }

    /** How much earlier light of the camera left what is now at the end of a way; NaN if none reaches the lens. */
    private double withLightOfTheCamera(Vector3dc way, double length) {
        Vector3d inCamera =
                outwards.difference(new Event(way.x(), way.y(), way.z(), 0)).position();
        Vector3d velocity = outwards.worldLine().position();
        // |inCamera - t velocity| = t
        double slower = 1 - velocity.lengthSquared();
        double along = inCamera.dot(velocity);
        double root = Math.sqrt(along * along + slower * length * length);
        double later = along >= 0 ? length * length / (along + root) : (root - along) / slower;
        return later >= 0 ? later : Double.NaN;
    }

    /** The Doppler factor of what rests in this frame, seen along a unit direction of the camera frame. */
    public double dopplerFactor(Vector3dc look) {
        return 1 / inwards.transform(Ray.from(0, 0, 0, look.x(), look.y(), look.z(), 0), Ray.blank()).frequency;
    }

    /**
     * The Doppler factor of what rests in this frame, seen along a unit direction of this frame, under the Lorentz
     * transformation. This keeps the digits that would be lost on the way by the direction in which the camera looks.
     */
    public double dopplerFactorAlong(Vector3dc direction) {
        return inCamera(direction).frequency;
    }

    private Ray inCamera(Vector3dc unit) {
        return outwards.transform(Ray.from(0, 0, 0, unit.x(), unit.y(), unit.z(), 0), Ray.blank());
    }

    private Vector3d measured(Vector3dc unit) {
        Event along = outwards.difference(new Event(unit.x(), unit.y(), unit.z(), 0));
        Event later = outwards.worldLine();
        return Vectors.unit(later.position().mul(-along.time() / later.time()).add(along.position()));
    }

    private Vector3d withLightOfTheCamera(Vector3dc unit) {
        Vector3d along =
                outwards.difference(new Event(unit.x(), unit.y(), unit.z(), 0)).position();
        Vector3d earlier = outwards.worldLine().position().negate();
        if (earlier.lengthSquared() >= 1) {
            return null;
        }
        // |k along + earlier| = 1
        double middle = along.dot(earlier);
        double root = Math.sqrt(middle * middle - along.lengthSquared() * (earlier.lengthSquared() - 1));
        double k = (root - middle) / along.lengthSquared();
        return Vectors.unit(earlier.fma(k, along));
    }
}
