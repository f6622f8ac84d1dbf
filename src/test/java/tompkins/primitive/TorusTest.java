package tompkins.primitive;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import optics.Torus;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.ray.RayPacket;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.search.NearestHit;
import tompkins.search.ObjectTree;
import tompkins.search.PacketSearch;
import tompkins.search.RandomAims;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameMotion;
import tompkins.spacetime.FrameTree;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.surface.ColouredSurface;

/**
 * A shape that the program does not know, and that is not convex, is met wherever shapes are. Expected is what a walk
 * along the ray meets whose steps are the distances from the torus, where every point has an exact one.
 */
class TorusTest {

    private static final double RADIUS = 1;
    private static final double TUBE = 0.3;
    private static final double FAR = 40;
    private static final double SPEED = 0.6;
    private static final double GAMMA = 1.25;
    private static final double ANGULAR_SPEED = 0.4;

    private final RandomAims random = new RandomAims(5);

    private static Torus torus(Vector3dc centre, Vector3dc axis) {
        return new Torus("torus", centre, axis, RADIUS, TUBE, ColouredSurface.DEFAULT);
    }

    private static Primitive placed(Torus torus) {
        return PrimitiveCollector.primitivesOf(torus).get(0);
    }

    /** How far a point is from the torus, without a sign. */
    private static double distance(Vector3dc point, Vector3dc centre, Vector3dc axis) {
        Vector3d from = point.sub(centre, new Vector3d());
        double height = from.dot(axis);
        double across = from.fma(-height, axis).length();
        return Math.abs(Math.hypot(across - RADIUS, height) - TUBE);
    }

    /** The least distance along a ray at which a function is 0 that falls by at most {@code slope} in a unit of it. */
    private static double walk(DoubleUnaryOperator function, double slope) {
        double at = 0;
        while (at < FAR) {
            double left = function.applyAsDouble(at);
            if (left < 1e-10) {
                return at;
            }
            at += left / slope;
        }
        return Primitive.NO_HIT;
    }

    private static Vector3d at(Ray ray, double distance) {
        return new Vector3d(ray.x, ray.y, ray.z).fma(distance, new Vector3d(ray.dx, ray.dy, ray.dz));
    }

    private static void isSame(double found, double expected) {
        assertThat(Math.min(found, FAR)).isCloseTo(Math.min(expected, FAR), within(1e-6));
    }

    private Ray aimed(double reach) {
        Vector3d start = random.vector(1).normalize(8);
        Vector3d direction = random.vector(reach).sub(start).normalize();
        return Ray.from(start.x, start.y, start.z, direction.x, direction.y, direction.z, random.mix(-5, 5));
    }

    /** In a tree, for rays alone and in packets. */
    @Test
    void treeFindsTheNearestOfMany() {
        PrimitiveCollector collector = new PrimitiveCollector();
        List<Vector3d> centres = new ArrayList<>();
        List<Vector3d> axes = new ArrayList<>();
        for (int i = 0; i < 2 * ObjectTree.SMALLEST_TREE; i++) {
            centres.add(random.vector(4));
            axes.add(random.vector(1).normalize());
            torus(centres.get(i), axes.get(i)).addTo(collector, Placement.NONE);
        }
        ObjectTree tree = new ObjectTree(collector.primitives(0));
        NearestHit alone = new NearestHit(new RayCounts());
        NearestHit inPacket = new NearestHit(new RayCounts());
        PacketSearch packet = new PacketSearch(tree, inPacket);
        RayPacket rays = new RayPacket(RayPacket.MOST);
        rays.begin(RayPacket.MOST);
        for (int i = 0; i < rays.count(); i++) {
            rays.set(i, aimed(3));
        }
        packet.begin(rays);
        int hits = 0;
        for (int i = 0; i < rays.count(); i++) {
            Ray ray = rays.copy(i, Ray.blank());
            double expected = walk(
                    t -> {
                        double least = FAR;
                        for (int j = 0; j < centres.size(); j++) {
                            least = Math.min(least, distance(at(ray, t), centres.get(j), axes.get(j)));
                        }
                        return least;
                    },
                    1);
            hits += expected < Primitive.NO_HIT ? 1 : 0;
            isSame(tree.nearest(ray, alone) ? alone.distance() : Primitive.NO_HIT, expected);
            isSame(packet.nearest(i, Primitive.NO_HIT) ? inPacket.distance() : Primitive.NO_HIT, expected);
        }
        assertThat(hits).isGreaterThan(50);
    }

    /** It flies along x; the walk sees each event of the ray from its frame by the textbook's formulas. */
    @Test
    void movingTorusIsMetInItsFrame() {
        FrameTree frames = FrameTree.described(TransformationLaw.LORENTZ);
        PrimitiveCollector collector = new PrimitiveCollector(point -> Event.ORIGIN, frames);
        Vector3d centre = new Vector3d(0.2, -0.3, 0.4);
        Vector3d axis = new Vector3d(1, 2, 2).div(3);
        collector.addMoving(
                Velocity.of(SPEED, 0, 0),
                new Vector3d(),
                0,
                Placement.NONE,
                inner -> torus(centre, axis).addTo(collector, inner));
        FrameMotion motion = collector.motions().get(1);
        ObjectTree tree = new ObjectTree(collector.primitives(1));
        NearestHit nearest = new NearestHit(new RayCounts());
        int hits = 0;
        for (int i = 0; i < 2000; i++) {
            Ray ray = aimed(2);
            Ray inFrame = frames.route(null, motion).transform(ray, Ray.blank());
            double found =
                    tree.nearest(inFrame, nearest) ? nearest.distance() / inFrame.directionLength : Primitive.NO_HIT;

            double expected = walk(
                    t -> {
                        Vector3d place = at(ray, t);
                        place.x = GAMMA * (place.x - SPEED * (ray.time - t));
                        return distance(place, centre, axis);
                    },
                    GAMMA * (1 + SPEED));
            hits += expected < Primitive.NO_HIT ? 1 : 0;
            isSame(found, expected);
        }
        assertThat(hits).isGreaterThan(30);
    }

    /** About z; the walk turns each point of the ray back, at its time. */
    @Test
    void turningTorusIsMetOnACurve() {
        Vector3d centre = new Vector3d(0.8, 0.1, 0.2);
        Vector3d axis = new Vector3d(2, -1, 2).div(3);
        Primitive torus = placed(torus(centre, axis));
        torus.setRestFrame(RestFrame.OUTERMOST.turning(
                new Rotation(new Vector3d(), new Vector3d(0, 0, 1), ANGULAR_SPEED, 0, 0, true)));
        ObjectTree tree = new ObjectTree(List.of(torus));
        NearestHit nearest = new NearestHit(new RayCounts());
        int hits = 0;
        int different = 0;
        for (int i = 0; i < 2000; i++) {
            Ray ray = aimed(2);
            double found = tree.nearest(ray, nearest) ? nearest.distance() : Primitive.NO_HIT;
            double expected = walk(
                    t -> distance(at(ray, t).rotateZ(-ANGULAR_SPEED * (ray.time - t)), centre, axis),
                    1 + 10 * ANGULAR_SPEED);
            hits += expected < Primitive.NO_HIT ? 1 : 0;
            different += found == expected || Math.abs(found - expected) < 1e-6 ? 0 : 1;
            if (found < Primitive.NO_HIT) {
                Hit hit = nearest.primitive().hit(ray, nearest.distance());
                assertThat(new Vector3d(hit.normalX, hit.normalY, hit.normalZ).length())
                        .isCloseTo(1, within(1e-12));
            }
        }
        assertThat(hits).isGreaterThan(200);
        // grazing rays
        assertThat(different).isLessThanOrEqualTo(1);
    }
}
