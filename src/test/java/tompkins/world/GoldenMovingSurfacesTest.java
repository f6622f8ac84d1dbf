package tompkins.world;

import static org.assertj.core.api.Assertions.assertThat;
import static tompkins.golden.GoldenTable.U;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import tompkins.golden.GoldenRow;
import tompkins.golden.GoldenTable;
import tompkins.golden.Worst;
import tompkins.light.Illumination;
import tompkins.math.Vectors;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.sceneobject.Plane;
import tompkins.spacetime.Event;
import tompkins.surface.Mirror;
import tompkins.surface.Refractive;
import tompkins.surface.Surface;
import tompkins.surface.Tracer;

/** Moving mirrors and the boundaries of moving media against the reference data, row by row. */
class GoldenMovingSurfacesTest {

    private static final List<GoldenRow> ROWS = GoldenTable.rows("m6_mirror_glass");
    private static final List<GoldenRow> MIRRORS =
            GoldenTable.rows("m6_mirror_glass", row -> row.has("kind", "mirror"));

    private static List<GoldenRow> decidable() {
        return ROWS.stream()
                .filter(row -> !row.isNumber("decidable_eps") || row.number("decidable_eps") >= 16 * U)
                .toList();
    }

    @Test
    void lightTakesItsWayInTheFrameOfTheSurface() {
        assertThat(Worst.of(decidable(), row -> {
                    Passage passage = new Passage(row);
                    return Math.max(
                            MovingQuantity.share(row, row.distance(direction(passage.before), "kd_"), "kd"),
                            MovingQuantity.share(row, row.distance(direction(passage.after), "ko_"), "ko"));
                }))
                .matches(Worst::passes);
    }

    @Test
    void lightGoesOnInTheScene() {
        assertThat(Worst.of(decidable(), row -> {
                    Passage passage = new Passage(row);
                    double tangentTime =
                            -passage.inScene.slowness * passage.inScene.directionLength / passage.after.directionLength;
                    return Math.max(
                            MovingQuantity.share(row, row.distance(direction(passage.inScene), "sdir_"), "sdir"),
                            MovingQuantity.share(row, row.difference(tangentTime, "st"), "st"));
                }))
                .matches(Worst::passes);
    }

    @Test
    void mediumDragsLight() {
        List<GoldenRow> rows = decidable().stream()
                .filter(row -> row.isNumber("speed") && row.isNumber("acond_speed"))
                .toList();
        assertThat(Worst.of(
                        rows,
                        row -> MovingQuantity.share(
                                row, row.difference(1 / new Passage(row).inScene.slowness, "speed"), "speed")))
                .matches(Worst::passes);
    }

    @Test
    void mirrorShiftsLight() {
        assertThat(Worst.of(
                        MIRRORS,
                        row -> MovingQuantity.share(
                                row, row.difference(new Passage(row).inScene.frequency, "ratio"), "ratio")))
                .matches(Worst::passes);
    }

    private static Vector3d direction(Ray ray) {
        return new Vector3d(ray.dx, ray.dy, ray.dz);
    }

    /** A ray before the surface and after it in the frame of the surface, and then in the scene. */
    private static final class Passage {
        final Ray before;
        final Ray after;
        final Ray inScene;

        Passage(GoldenRow row) {
            Vector3d normal = Vectors.unit(row.vector("n_"));
            boolean isMirror = row.has("kind", "mirror");
            boolean leaves = row.has("kind", "exit");
            double from = isMirror ? 1 : row.number("n1");
            double to = isMirror ? 1 : row.number("n2");
            Surface surface = isMirror ? new Mirror(1) : new Refractive(leaves ? from / to : to / from);
            MovingRow scene = MovingRow.of(
                    List.of(MovingRow.moving(
                            row.vector("v_"), new Vector3d(), 0, new Plane("", new Vector3d(), normal, surface))),
                    new Vector3d(),
                    Event.ORIGIN,
                    false);
            int frame = scene.world.frames().size() - 1;
            Vector3d d = Vectors.unit(row.vector("d_"));
            Ray start = Ray.from(0, 0, 0, d.x, d.y, d.z, 0);
            if (leaves) {
                start.slowness = from;
                before = start;
            } else {
                before = scene.routes.transform(start, frame, Ray.blank());
            }
            if (!isMirror && direction(before).dot(normal) > 0 != leaves) {
                normal.negate();
            }
            Hit hit = Hit.blank().set(before, 1, normal.x, normal.y, normal.z, null, 0, null);
            List<Ray> rays = new ArrayList<>();
            rays.add(surface.respond(before, hit, new Tracer() {
                        @Override
                        public Colour colour(Ray ray) {
                            rays.add(ray);
                            return Colour.BLACK;
                        }

                        @Override
                        public Illumination illumination() {
                            throw new IllegalStateException("nothing is lit here");
                        }
                    })
                    .next());
            boolean bends = !isMirror && !row.has("tir", "1");
            after = rays.stream()
                    .filter(ray -> isMirror
                            || direction(ray).dot(normal) * direction(before).dot(normal) > 0 == bends)
                    .findFirst()
                    .orElseThrow();
            inScene = scene.routes.route(frame, 0).transform(after, Ray.blank());
        }
    }
}
