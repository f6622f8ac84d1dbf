package tompkins.measure;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.property.InvalidPropertyException;
import tompkins.spacetime.Event;
import tompkins.spacetime.SpaceTimeTransformation;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;
import tompkins.world.FrameAppearance;

/** The ways of one pixel's light through the rim of the lens, and where in the scene they pass the point in focus. */
final class LensWays {

    private static final int RIM_POINTS = 360;

    /** Rays at smaller angles meet so far away that the distance is unknown; the sine of the angle. */
    private static final double PARALLEL = 1e-9;

    private LensWays() {}

    /**
     * The blur of what is in focus at a pixel, in pixels: the rays of the pixel pass the point where they all meet in
     * the camera frame at different places in the scene, and this is the largest distance between those as the middle
     * of the lens sees them.
     *
     * @throws InvalidPropertyException if they do not meet, or pass what the middle of the lens does not see
     */
    static double spread(RenderPlan plan, Vector2dc pixel) {
        Vector3dc focus = meeting(life(plan, pixel, 0, 0), life(plan, pixel, 1, 0));
        SpaceTimeTransformation sceneFromCamera = plan.studio().sceneFromCamera();
        FrameAppearance scene = new FrameAppearance(plan.studio(), null);
        Projection projection = Projection.at(plan.studio(), pixel);
        List<Vector2dc> passed = new ArrayList<>();
        for (int i = 0; i < RIM_POINTS; i++) {
            double angle = 2 * Math.PI * i / RIM_POINTS;
            SampleHistory life = life(plan, pixel, Math.cos(angle), Math.sin(angle));
            Vector3d fromLens = focus.sub(life.cameraStart().position(), new Vector3d());
            double way = fromLens.dot(life.cameraDirection());
            Event passing = new Event(
                    focus.x(), focus.y(), focus.z(), life.cameraStart().time() - way);
            Vector2dc seen = projection.position(
                    scene, sceneFromCamera.transform(passing).position());
            if (seen == null) {
                throw new InvalidPropertyException(
                        "point", "where the middle of the lens sees it", "one that it does not");
            }
            passed.add(seen);
        }
        return passed.stream()
                .flatMapToDouble(one -> passed.stream().mapToDouble(one::distance))
                .max()
                .orElseThrow();
    }

    private static SampleHistory life(RenderPlan plan, Vector2dc pixel, double lensX, double lensY) {
        return Sighting.required(plan, pixel, lensX, lensY).life();
    }

    /** The point of the chief ray that is nearest to another ray. */
    private static Vector3dc meeting(SampleHistory chief, SampleHistory other) {
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
