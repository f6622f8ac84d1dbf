package tompkins.measure;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import tompkins.light.LightSource;
import tompkins.light.MovingLights;
import tompkins.light.PointLight;
import tompkins.studio.Studio;
import tompkins.studio.StudioPath;
import tompkins.trace.RenderPlan;
import tompkins.world.FrameAppearance;
import tompkins.world.InertialFrame;
import tompkins.world.Lamp;

/**
 * Where a picture would show a lamp, which is too small to be seen: the place from which its light comes.
 *
 * @param path the way to it in the studio
 * @param place where it is seen, in pixels of the plan
 */
public record SeenLamp(StudioPath path, Vector2dc place) {

    /** Within this part of the picture's width a place is that of a lamp. */
    private static final double REACH = 1 / 80.0;

    /** The lamps that lie within the edges of a picture. */
    public static List<SeenLamp> of(RenderPlan plan) {
        Studio studio = plan.studio();
        List<StudioPath> paths = new ArrayList<>();
        addPaths(StudioPath.ROOT.then("lights"), studio.lights(), paths);
        Projection projection = Projection.of(studio);
        List<SeenLamp> seen = new ArrayList<>();
        for (int i = 0; i < paths.size(); i++) {
            Lamp lamp = plan.world().lamps().get(i);
            if (lamp.light() instanceof PointLight light) {
                InertialFrame frame = plan.world().frames().get(lamp.frame());
                Vector3d point = light.position().add(frame.origin().position(), new Vector3d());
                Vector2dc place = projection.position(new FrameAppearance(studio, frame.motion()), point);
                if (projection.shows(place)) {
                    seen.add(new SeenLamp(paths.get(i), place));
                }
            }
        }
        return seen;
    }

    /** The ways to all that rests, in the order of the lamps of a world. */
    private static void addPaths(StudioPath list, List<LightSource> lights, List<StudioPath> paths) {
        for (int i = 0; i < lights.size(); i++) {
            StudioPath path = list.then(i);
            if (lights.get(i) instanceof MovingLights moving) {
                addPaths(path.then("objects"), moving.objects(), paths);
            } else {
                paths.add(path);
            }
        }
    }

    /** The lamp that a picture shows at a place, in pixels of the plan, or near it. */
    public static Optional<SeenLamp> near(RenderPlan plan, double x, double y) {
        return of(plan).stream()
                .filter(lamp -> lamp.place.distance(x, y) < REACH * plan.width())
                .min(Comparator.comparingDouble(lamp -> lamp.place.distance(x, y)));
    }
}
