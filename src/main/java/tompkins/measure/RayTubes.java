package tompkins.measure;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.ray.Colour;
import tompkins.sceneobject.Cylinder;
import tompkins.sceneobject.Group;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.studio.Studio;
import tompkins.surface.LuminousSurface;
import tompkins.trace.Frame;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;

/**
 * Draws rays into the scene: a rod for each straight piece of all branches, and a ball at each hit. They are objects of
 * the scene like others, and rest in it: the ball on something that moves lies where that was hit. What a ray does in
 * the camera frame is not drawn, and near the lens nothing is.
 */
public final class RayTubes {

    private static final LuminousSurface STRONGEST = new LuminousSurface(new Colour(0.6, 0.05, 0.85), false);
    private static final LuminousSurface WEAKER = new LuminousSurface(new Colour(0.75, 0.5, 0.9), false);

    /** Half the thickness of a rod, as a share of the median distance of the hits from the start. */
    private static final double THICKNESS = 1.0 / 250;

    /** The radius of a ball, in radii of a rod. */
    private static final double BALL = 2;

    /** How near the lens nothing is drawn, in radii of a rod, so that little is hidden from there. */
    private static final double GAP = 30;

    /** How long rays are drawn that hit nothing at all: as far as new objects stand from the origin. */
    private static final double UNBOUNDED = Sphere.DEFAULT.centre().length();

    /** The distance of the rays around that of a pinhole from it, in heights of the picture. */
    private static final double OPENING = 0.05;

    private final double radius;
    private final double reach;

    private RayTubes(List<SampleHistory> rays) {
        double[] distances = rays.stream()
                .flatMapToDouble(RayTubes::distances)
                .filter(distance -> distance > 0)
                .sorted()
                .toArray();
        boolean unbounded = distances.length == 0;
        radius = THICKNESS * (unbounded ? UNBOUNDED : distances[distances.length / 2]);
        reach = unbounded ? UNBOUNDED : distances[distances.length - 1];
    }

    private static Stream<SampleHistory.Encounter> hits(SampleHistory ray) {
        return ray.hits().stream().filter(hit -> hit.frame() == Frame.SCENE);
    }

    /** The distances of all hits in the scene from the start of the first piece there. */
    private static DoubleStream distances(SampleHistory ray) {
        return hits(ray)
                .mapToDouble(hit -> hit.event()
                        .position()
                        .distance(ray.segments().get(0).start().position()));
    }

    /** Whether there is anything of some rays to draw: whether one of them enters the scene. */
    public static boolean canDraw(List<SampleHistory> rays) {
        return rays.stream().anyMatch(ray -> !ray.segments().isEmpty());
    }

    /**
     * A studio with rays drawn into its scene, after all objects that are there.
     *
     * @param name name of the group that holds them
     * @param rays all of one thickness, which suits the distances of their hits; several have a group each
     */
    public static Studio addedTo(Studio studio, String name, List<SampleHistory> rays) {
        return studio.withScene(Stream.concat(studio.scene().stream(), Stream.of(of(name, rays)))
                .toList());
    }

    /**
     * Follows rays evenly around that of a point of the picture: with a wide aperture those of the point itself,
     * through the edge of the lens; else those through a circle around the point. Rays that never cross the shutter are
     * left out.
     *
     * @param x place in the picture in pixels
     * @param y place in the picture in pixels
     * @param count the number of rays
     * @param moment the part of the exposure time that has passed, from 0 to 1; the same for all
     */
    public static List<SampleHistory> cone(RenderPlan plan, double x, double y, int count, double moment) {
        boolean throughEdge = plan.studio().camera().hasWideAperture();
        double opening = throughEdge ? 0 : OPENING * plan.height();
        double aperture = throughEdge ? 1 : 0;
        List<SampleHistory> rays = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            double angle = 2 * Math.PI * i / count;
            double right = Math.cos(angle);
            double up = Math.sin(angle);
            SampleHistory ray = SampleHistory.of(
                    plan, x + opening * right, y - opening * up, aperture * right, aperture * up, moment);
            if (ray != null) {
                rays.add(ray);
            }
        }
        return rays;
    }

    /** The group of the rods and balls of rays. */
    static Group of(String name, List<SampleHistory> rays) {
        RayTubes tubes = new RayTubes(rays);
        if (rays.size() == 1) {
            return new Group(name, tubes.parts(rays.get(0)));
        }
        List<SceneObject> groups = new ArrayList<>();
        for (SampleHistory ray : rays) {
            groups.add(new Group("ray " + (groups.size() + 1), tubes.parts(ray)));
        }
        return new Group(name, groups);
    }

    private List<SceneObject> parts(SampleHistory ray) {
        List<SceneObject> parts = new ArrayList<>();
        for (SampleHistory.Segment segment : ray.segments()) {
            Vector3dc lens = ray.segments().get(0).start().position();
            LuminousSurface surface = segment.branch() == 0 ? STRONGEST : WEAKER;
            Vector3d start = segment.start().position();
            Vector3d end = end(segment);
            String to = segment.hit() == null
                    ? "the background"
                    : segment.hit().object().description();
            double[] shares = awayFrom(lens, start, end);
            for (int i = 0; i < shares.length; i += 2) {
                if (shares[i] < shares[i + 1]) {
                    Vector3d from = shares[i] == 0 ? start : start.lerp(end, shares[i], new Vector3d());
                    Vector3d until = shares[i + 1] == 1 ? end : start.lerp(end, shares[i + 1], new Vector3d());
                    parts.add(new Cylinder("to " + to, from, until, radius, true, surface));
                }
            }
            if (segment.hit() != null && end.distance(lens) > GAP * radius) {
                parts.add(new Sphere("hit on " + to, end, BALL * radius, surface));
            }
        }
        return parts;
    }

    private Vector3d end(SampleHistory.Segment segment) {
        return segment.hit() == null
                ? segment.start().position().fma(reach, segment.direction())
                : segment.hit().event().position();
    }

    /**
     * The parts of a straight piece that are not near the lens: where the first and the second begin and end, as shares
     * of its length. What a mirror sends straight back passes the lens, too.
     */
    private double[] awayFrom(Vector3dc lens, Vector3dc start, Vector3dc end) {
        double length = start.distance(end);
        if (length == 0) {
            return new double[0];
        }
        Vector3d way = end.sub(start, new Vector3d()).div(length);
        Vector3d toLens = lens.sub(start, new Vector3d());
        double along = toLens.dot(way);
        double aside = toLens.fma(-along, way).length();
        double gap = GAP * radius;
        double half = aside < gap ? Math.sqrt((gap - aside) * (gap + aside)) : 0;
        double enters = Math.max(0, Math.min(1, (along - half) / length));
        double leaves = Math.max(0, Math.min(1, (along + half) / length));
        return half == 0 ? new double[] {0, 1} : new double[] {0, enters, leaves, 1};
    }
}
