package tompkins.world;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.math.Vectors;
import tompkins.primitive.Primitive;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.ray.RayPacket;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.search.RandomAims;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameTree;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.surface.ColouredSurface;

/** The nearest hit among objects with several velocities, against asking every primitive of every frame. */
class SurroundingsTest {

    private static SceneObject moving(double speed, SceneObject... objects) {
        return new Moving("moving", Velocity.of(speed, 0, 0), new Vector3d(), 0, List.of(objects));
    }

    private static SceneObject[] balls(int count, double radius, double reach, RandomAims random) {
        return IntStream.range(0, count)
                .mapToObj(
                        i -> new Sphere("", random.vector(reach).add(0, 0, 3 * reach), radius, ColouredSurface.DEFAULT))
                .toArray(SceneObject[]::new);
    }

    /** Few large balls make candidates for the packet, many small ones leave the search to groups or single rays. */
    @ParameterizedTest
    @CsvSource({"3, 5, 0.2", "40, 0.8, 0.2", "400, 0.2, 0.2", "4000, 0.05, 0.3", "4000, 0.1, 0.9"})
    void packetsAndRaysFindTheNearest(int count, double radius, double angle) {
        RandomAims random = new RandomAims(count);
        List<SceneObject> scene = new ArrayList<>(List.of(balls(count, radius, 10, random)));
        scene.add(moving(0.6, balls(count, radius, 10, random)));
        scene.add(moving(-0.9, balls(count, radius, 10, random)));
        Found found = new Found(scene);
        RayPacket rays = new RayPacket(RayPacket.MOST);
        rays.begin(RayPacket.MOST - 7);
        for (int i = 0; i < rays.count(); i++) {
            Vector3d to = Vectors.unit(random.vector(angle).setComponent(2, 1));
            rays.set(i, Ray.from(0, 0, 0, to.x, to.y, to.z, 0));
        }

        found.search.begin(rays);
        int hits = 0;
        for (int i = 0; i < rays.count(); i++) {
            Nearest expected = found.byAsking(rays.ray(i));
            assertThat(found.inPacket(i)).isEqualTo(expected);
            hits += expected.primitive == null ? 0 : 1;
        }

        assertThat(hits).isGreaterThan(rays.count() / 20);
        for (int i = 0; i < rays.count(); i += 5) {
            assertThat(found.alone(rays.ray(i))).isEqualTo(found.byAsking(rays.ray(i)));
        }
    }

    /** Of two walls in one place, one of which moves along itself, the one that is listed first is seen. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void ofEquallyNearThingsTheFirstIsFound(boolean movingFirst) {
        SceneObject wall = new Plane("wall", new Vector3d(0, 0, 5), new Vector3d(0, 0, 1), ColouredSurface.DEFAULT);
        SceneObject passing = moving(0.6, wall);
        Found found = new Found(movingFirst ? List.of(passing, wall) : List.of(wall, passing));
        Ray ray = Ray.from(0, 0, 0, 0, 0, 1, 0);
        RayPacket rays = new RayPacket(1);
        rays.begin(1);
        rays.set(0, ray);

        found.search.begin(rays);

        assertThat(found.inPacket(0).frame).isEqualTo(movingFirst ? 1 : 0);
        assertThat(found.alone(ray).frame).isEqualTo(movingFirst ? 1 : 0);
    }

    /** What was found: the primitive, or null, and its frame. */
    private record Nearest(Primitive primitive, int frame) {}

    /** A scene and its search. */
    private static final class Found {
        final World world;
        final FrameRoutes routes;
        final Surroundings search;

        Found(List<SceneObject> scene) {
            Studio studio = Studio.DEFAULT.withScene(scene);
            FrameTree frames = FrameTree.near(Event.ORIGIN, studio.transformation(), studio.velocity());
            world = new World(studio, frames, point -> Event.ORIGIN);
            routes = world.routes(frames);
            search = world.surroundings(routes, studio.transformation(), new RayCounts());
        }

        Nearest inPacket(int place) {
            return result(search.nearest(place, Hit.blank()));
        }

        Nearest alone(Ray ray) {
            return result(search.nearest(ray, Hit.blank()));
        }

        private static Nearest result(Hit hit) {
            return hit == null ? new Nearest(null, 0) : new Nearest((Primitive) hit.boundary, hit.ray.frame);
        }

        Nearest byAsking(Ray ray) {
            Nearest best = new Nearest(null, 0);
            double least = Double.POSITIVE_INFINITY;
            for (int frame = 0; frame < world.frames().size(); frame++) {
                Ray inFrame = routes.transform(ray, frame, Ray.blank());
                for (Primitive primitive : world.objects(frame).primitives()) {
                    double distance = primitive.distance(inFrame, Primitive.NO_HIT) / inFrame.directionLength;
                    if (distance < least) {
                        least = distance;
                        best = new Nearest(primitive, frame);
                    }
                }
            }
            return best;
        }
    }
}
