package tompkins.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import tompkins.sceneobject.Box;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Placed;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.surface.LuminousSurface;
import tompkins.surface.Tiling;
import tompkins.trace.RenderPlan;

/** Normals and coordinates of hits, in the frame in which an object rests. */
class RayTableTest {

    private static final Vector3d CENTRE = new Vector3d(0.2, 0.3, 0.1);
    private static final double RADIUS = 1.5;
    private static final Vector3d PLACE = new Vector3d(-5, 0, 9);

    private final Set<String> seen = new TreeSet<>();

    private static double number(Sighting sighting, String column) {
        return RayTable.number(sighting, column);
    }

    private static Vector3d vector(Sighting sighting, String column) {
        return new Vector3d(
                number(sighting, column + "_x"), number(sighting, column + "_y"), number(sighting, column + "_z"));
    }

    private void check(List<SceneObject> scene) {
        RenderPlan plan = RenderPlan.of(
                Studio.DEFAULT.withVelocity(Velocity.of(0.1, 0.2, 0.5)).withScene(scene));
        for (int x = 5; x < 640; x += 10) {
            for (int y = 5; y < 480; y += 10) {
                Sighting sighting = Sighting.of(plan, x + 0.5, y + 0.5);
                if (sighting.hit() == null) {
                    assertThat(number(sighting, "surface_u")).isNaN();
                    continue;
                }
                String object = sighting.hit().object().description();
                seen.add(object);
                Vector3d own = vector(sighting, "hit_own");
                Vector3d normal = vector(sighting, "normal");
                double u = number(sighting, "surface_u");
                double v = number(sighting, "surface_v");
                switch (object) {
                    case "ball" -> checkBall(own, normal, u, v);
                    case "floor" -> checkFloor(own, normal, u, v);
                    default -> checkBox(own, normal, u, v);
                }
            }
        }
    }

    /** u runs once around from behind, through the side of -z in its middle, and v from pole to pole. */
    private static void checkBall(Vector3d own, Vector3d normal, double u, double v) {
        Vector3d out = own.sub(CENTRE, new Vector3d()).div(RADIUS);
        assertThat(out.length()).isCloseTo(1, within(1e-12));
        assertThat(normal.distance(out)).isLessThan(1e-12);
        assertThat(u).isCloseTo(Math.atan2(out.x, -out.z) / (2 * Math.PI) + 0.5, within(1e-12));
        assertThat(v).isCloseTo(Math.asin(out.y) / Math.PI + 0.5, within(1e-9));
    }

    /** u and v are lengths along x and z, from the point of the plane. */
    private static void checkFloor(Vector3d own, Vector3d normal, double u, double v) {
        assertThat(own.y).isCloseTo(-2, within(1e-12));
        assertThat(normal).isEqualTo(new Vector3d(0, 1, 0));
        assertThat(u).isCloseTo(own.x - 3, within(1e-11));
        assertThat(v).isCloseTo(own.z - 4, within(1e-11));
    }

    /**
     * A cube of side 2 about (2, 0, 7), turned by 90 degrees about z: its own x points up, and its own y to the left.
     */
    private static void checkBox(Vector3d own, Vector3d normal, double u, double v) {
        Vector3d from = own.sub(2, 0, 7, new Vector3d());
        assertThat(Math.max(Math.abs(from.x), Math.max(Math.abs(from.y), Math.abs(from.z))))
                .isCloseTo(1, within(1e-12));
        assertThat(normal.dot(from)).isCloseTo(1, within(1e-12));
        if (normal.z < -0.5) {
            // in front, u ran along x, now up, and v along y, now to the left
            assertThat(u).isCloseTo((from.y + 1) / 2, within(1e-12));
            assertThat(v).isCloseTo((1 - from.x) / 2, within(1e-12));
        } else {
            assertThat(u).isBetween(0.0, 1.0);
            assertThat(v).isBetween(0.0, 1.0);
        }
    }

    @Test
    void surfacesTellWhereTheyAreHit() {
        SceneObject ball = new Sphere("ball", CENTRE, RADIUS, Tiling.DEFAULT);
        SceneObject box = new Box("box", new Vector3d(-1, -1, -1), new Vector3d(1, 1, 1), Tiling.DEFAULT);
        check(List.of(
                new Moving("", Velocity.of(-0.6, 0.1, 0), PLACE, 0, List.of(ball)),
                new Placed("", box, 1, new Vector3d(0, 0, 1), 90, new Vector3d(2, 0, 7)),
                new Plane("floor", new Vector3d(3, -2, 4), new Vector3d(0, 1, 0), Tiling.DEFAULT)));

        assertThat(seen).containsExactly("ball", "box", "floor");
    }

    /** In one colour a surface has no use for coordinates; its normal looks back along the view all the same. */
    @Test
    void surfacesInOneColourHaveNormalsAlone() {
        SceneObject ball = new Sphere("ball", new Vector3d(0, 0, 10), 1, LuminousSurface.DEFAULT);
        Sighting middle = Sighting.of(RenderPlan.of(Studio.DEFAULT.withScene(List.of(ball))), 320, 240);

        assertThat(vector(middle, "normal").distance(0, 0, -1)).isLessThan(1e-12);
        assertThat(number(middle, "surface_u")).isNaN();
        assertThat(number(middle, "surface_v")).isNaN();
    }
}
