package tompkins.measure;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.joml.Vector3d;
import tompkins.ray.Colour;
import tompkins.sceneobject.Cylinder;
import tompkins.sceneobject.Group;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.Event;
import tompkins.studio.Studio;
import tompkins.surface.LuminousSurface;
import tompkins.trace.Frame;
import tompkins.trace.RayLife;

/**
 * Draws rays into the scene: a rod for each straight piece of all branches, and a ball at each hit. They are objects of
 * the scene like others, and rest in it: the ball on something that moves lies where that was hit. What a ray does in
 * the camera frame is not drawn.
 */
public final class RayTubes {

    private static final LuminousSurface STRONGEST = new LuminousSurface(new Colour(0.6, 0.05, 0.85), false);
    private static final LuminousSurface WEAKER = new LuminousSurface(new Colour(0.75, 0.5, 0.9), false);

    /** Half the thickness of a rod, as a share of the median distance of the hits from the start. */
    private static final double THICKNESS = 1.0 / 250;

    /** The radius of a ball, in radii of a rod. */
    private static final double BALL = 2;

    /** How far from the camera the first rod begins, in radii, so that it hides little from there. */
    private static final double GAP = 30;

    /** How long rays are drawn that hit nothing at all: as far as new objects stand from the origin. */
    private static final double UNBOUNDED = Sphere.DEFAULT.centre().length();

    private final double radius;
    private final double reach;

    /** The events at which rays were hit, where rods meet. */
    private final Set<Event> corners = new HashSet<>();

    private RayTubes(List<RayLife> rays) {
        double[] distances = rays.stream()
                .flatMapToDouble(RayTubes::distances)
                .filter(distance -> distance > 0)
                .sorted()
                .toArray();
        boolean unbounded = distances.length == 0;
        radius = THICKNESS * (unbounded ? UNBOUNDED : distances[distances.length / 2]);
        reach = unbounded ? UNBOUNDED : distances[distances.length - 1];
        rays.forEach(ray -> hits(ray).forEach(hit -> corners.add(hit.event())));
    }

    private static Stream<RayLife.Encounter> hits(RayLife ray) {
        return ray.hits().stream().filter(hit -> hit.frame() == Frame.SCENE);
    }

    /** The distances of all hits in the scene from the start of the first piece there. */
    private static DoubleStream distances(RayLife ray) {
        return hits(ray)
                .mapToDouble(hit -> hit.event()
                        .position()
                        .distance(ray.segments().get(0).start().position()));
    }

    /** Whether there is anything of some rays to draw: whether one of them enters the scene. */
    public static boolean canDraw(List<RayLife> rays) {
        return rays.stream().anyMatch(ray -> !ray.segments().isEmpty());
    }

    /**
     * A studio with rays drawn into its scene, after all objects that are there.
     *
     * @param name name of the group that holds them
     * @param rays all of one thickness, which suits the distances of their hits; several have a group each
     */
    public static Studio addedTo(Studio studio, String name, List<RayLife> rays) {
        return studio.withScene(Stream.concat(studio.scene().stream(), Stream.of(of(name, rays)))
                .toList());
    }

    /** The group of the rods and balls of rays. */
    static Group of(String name, List<RayLife> rays) {
        RayTubes tubes = new RayTubes(rays);
        if (rays.size() == 1) {
            return new Group(name, tubes.parts(rays.get(0)));
        }
        List<SceneObject> groups = new ArrayList<>();
        for (RayLife ray : rays) {
            groups.add(new Group("ray " + (groups.size() + 1), tubes.parts(ray)));
        }
        return new Group(name, groups);
    }

    private List<SceneObject> parts(RayLife ray) {
        List<SceneObject> parts = new ArrayList<>();
        for (RayLife.Segment segment : ray.segments()) {
            LuminousSurface surface = segment.branch() == 0 ? STRONGEST : WEAKER;
            Vector3d end = end(segment);
            Vector3d start = start(segment, end);
            String to = segment.hit() == null
                    ? "the background"
                    : segment.hit().object().description();
            if (!start.equals(end)) {
                parts.add(new Cylinder("to " + to, start, end, radius, true, surface));
            }
            if (segment.hit() != null) {
                parts.add(new Sphere("hit on " + to, end, BALL * radius, surface));
            }
        }
        return parts;
    }

    private Vector3d end(RayLife.Segment segment) {
        if (segment.hit() != null) {
            return segment.hit().event().position();
        }
        return segment.start().position().fma(reach, segment.direction());
    }

    /** Where the rod of a piece begins: that of one that comes from the camera leaves some room. */
    private Vector3d start(RayLife.Segment segment, Vector3d end) {
        Vector3d start = segment.start().position();
        if (corners.contains(segment.start())) {
            return start;
        }
        double length = start.distance(end);
        return length == 0 ? start : start.lerp(end, Math.min(0.5, GAP * radius / length));
    }
}
