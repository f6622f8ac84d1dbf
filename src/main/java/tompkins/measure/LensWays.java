package tompkins.measure;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.property.InvalidPropertyException;
import tompkins.spacetime.Event;
import tompkins.spacetime.SpaceTimeTransformation;
import tompkins.trace.RayLife;
import tompkins.trace.RenderPlan;

/** The ways of one pixel's light through the rim of the lens, and where in the scene they pass the point in focus. */
final class LensWays {

    private static final int RIM_POINTS = 360;

    /** Rays at smaller angles meet so far away that the distance is unknown; the sine of the angle. */
    private static final double PARALLEL = 1e-9;

    private LensWays() {}

    /**
     * The largest distance, in scene units, between the positions in the scene at which the rays of a pixel pass the
     * point where they all meet in the camera frame.
     *
     * @throws InvalidPropertyException if they do not meet
     */
    static double spread(RenderPlan plan, Vector2dc pixel) {
        Vector3dc focus = meeting(life(plan, pixel, 0, 0), life(plan, pixel, 1, 0));
        SpaceTimeTransformation sceneFromCamera = plan.studio().sceneFromCamera();
        List<Vector3d> passed = new ArrayList<>();
        for (int i = 0; i < RIM_POINTS; i++) {
            double angle = 2 * Math.PI * i / RIM_POINTS;
            RayLife life = life(plan, pixel, Math.cos(angle), Math.sin(angle));
            Vector3d fromLens = focus.sub(life.cameraStart().position(), new Vector3d());
            double way = fromLens.dot(life.cameraDirection());
            Event passing = new Event(
                    focus.x(), focus.y(), focus.z(), life.cameraStart().time() - way);
            passed.add(sceneFromCamera.transform(passing).position());
        }
        return passed.stream()
                .flatMapToDouble(one -> passed.stream().mapToDouble(one::distance))
                .max()
                .orElseThrow();
    }

    private static RayLife life(RenderPlan plan, Vector2dc pixel, double lensX, double lensY) {
        return Sighting.required(plan, pixel, lensX, lensY).life();
    }

    /** The point of the chief ray that is nearest to another ray. */
    private static Vector3dc meeting(RayLife chief, RayLife other) {
        Vector3dc a = chief.cameraDirection();
        Vector3dc b = other.cameraDirection();
        Vector3d across = b.sub(a.mul(a.dot(b), new Vector3d()), new Vector3d());
        if (across.length() < PARALLEL) {
            throw new InvalidPropertyException("point", "where the rays of a wide lens meet", "one where they do not");
        }
        Vector3d start = other.cameraStart().position().sub(chief.cameraStart().position());
        double wayOfOther = -start.dot(across) / across.dot(across);
        double way = start.dot(a) + wayOfOther * a.dot(b);
        return chief.cameraStart().position().add(a.mul(way, new Vector3d()));
    }
}
