package tompkins.measure;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;
import tompkins.ray.Ray;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameMotion;
import tompkins.spacetime.IdentityTransformation;
import tompkins.spacetime.SpaceTimeTransformation;
import tompkins.spacetime.TransformationLaw;
import tompkins.studio.Studio;
import tompkins.studio.View;

/**
 * How the camera sees what rests in one frame of the scene. An object at rest in the frame is seen along a direction of
 * that frame, from the event at which its light crosses the lens; so only directions have to be worked out. A direction
 * n that is followed backwards in time has the tangent (n, -1), which the change of frame takes to the camera. In the
 * measured view the tangent lies in one time of the camera. In a Galilean world light has speed 1 in the camera frame,
 * and the tangent is (k n, -1) with the k that gives this speed.
 */
public final class SeenFrame {

    private static final Event REST = new Event(0, 0, 0, 1);

    private final SpaceTimeTransformation sceneFromCamera;

    /** What the motion of the camera does to what it sees. */
    private final SpaceTimeTransformation cameraFromScene;

    private final TransformationLaw law;
    private final View view;
    private final List<FrameMotion> outerFirst = new ArrayList<>();
    private final List<SpaceTimeTransformation> outwards = new ArrayList<>();

    /** The frame of a motion, in the view of the studio; null means the scene frame. */
    public SeenFrame(Studio studio, FrameMotion motion) {
        this(studio, motion, studio.view());
    }

    /** The frame of a motion, or the scene frame if that is null, in a view. */
    public SeenFrame(Studio studio, FrameMotion motion, View view) {
        this(studio, motion, view, studio.sceneFromCamera().inverse());
    }

    private SeenFrame(Studio studio, FrameMotion motion, View view, SpaceTimeTransformation cameraFromScene) {
        this.view = view;
        this.cameraFromScene = cameraFromScene;
        law = studio.transformation();
        sceneFromCamera = studio.sceneFromCamera();
        for (FrameMotion each = motion; each != null; each = each.outer()) {
            outerFirst.add(0, each);
            outwards.add(law.sceneFromCamera(each.velocity()));
        }
    }

    /**
     * The frame of a motion, or the scene frame if that is null, as a camera sees it that rests in the scene, at the
     * same event and with the same axes.
     */
    static SeenFrame atRest(Studio studio, FrameMotion motion) {
        return new SeenFrame(studio, motion, studio.view(), new IdentityTransformation());
    }

    /** An event of the camera frame, in this frame. */
    public Event fromCamera(Event event) {
        Event inside = sceneFromCamera.transform(event);
        int depth = outerFirst.size();
        for (int i = 0; i < depth; i++) {
            inside = outwards.get(depth - 1 - i)
                    .inverse()
                    .transform(inside.minus(outerFirst.get(i).start()));
        }
        return inside;
    }

    /** A difference of two events of this frame, in the camera frame. */
    public Event differenceInCamera(Event difference) {
        Event outside = difference;
        for (SpaceTimeTransformation change : outwards) {
            outside = change.transform(outside);
        }
        return cameraFromScene.transform(outside);
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
        return law == TransformationLaw.GALILEAN ? withLightOfTheCamera(unit) : relativistic(unit);
    }

    private Vector3d relativistic(Vector3dc unit) {
        Ray ray = Ray.from(0, 0, 0, unit.x(), unit.y(), unit.z(), 0);
        for (SpaceTimeTransformation change : outwards) {
            ray = change.transform(ray);
        }
        Ray seen = cameraFromScene.transform(ray);
        return new Vector3d(seen.dx, seen.dy, seen.dz);
    }

    private Vector3d measured(Vector3dc unit) {
        Event along = differenceInCamera(new Event(unit.x(), unit.y(), unit.z(), 0));
        Event later = differenceInCamera(REST);
        return Vectors.unit(later.position().mul(-along.time() / later.time()).add(along.position()));
    }

    private Vector3d withLightOfTheCamera(Vector3dc unit) {
        Vector3d along =
                differenceInCamera(new Event(unit.x(), unit.y(), unit.z(), 0)).position();
        Vector3d earlier = differenceInCamera(REST).position().negate();
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
