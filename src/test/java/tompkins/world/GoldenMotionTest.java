package tompkins.world;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import tompkins.golden.GoldenRow;
import tompkins.golden.GoldenTable;
import tompkins.golden.Worst;
import tompkins.math.Vectors;
import tompkins.primitive.RestFrame;
import tompkins.ray.Ray;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameMotion;
import tompkins.spacetime.FrameTree;
import tompkins.surface.ColouredSurface;

/** Points, clocks and rods in motion, and motion within motion, against the reference data, row by row. */
class GoldenMotionTest {

    private static final List<GoldenRow> POINTS = GoldenTable.rows("m4_closed_forms", row -> row.has("kind", "point"));
    private static final List<GoldenRow> CLOCKS = GoldenTable.rows("m4_closed_forms", row -> row.has("kind", "clock"));
    private static final List<GoldenRow> RODS = GoldenTable.rows("m7_measured_lengths");
    private static final List<GoldenRow> NESTED = GoldenTable.rows("m5_nested");

    private static double share(GoldenRow row, double value, String column) {
        return MovingQuantity.share(row, row.difference(value, column), column);
    }

    @Test
    void pointsAreSeenWhereTheyWere() {
        assertThat(Worst.of(POINTS, row -> {
                    FoundHit hit = AimedRay.atPoint(row).hit;
                    return Math.max(share(row, hit.lambda(), "distance"), share(row, hit.dopplerFactor(), "D"));
                }))
                .matches(Worst::passes);
    }

    @Test
    void clocksShowTheirTime() {
        assertThat(Worst.of(CLOCKS, row -> {
                    FoundHit hit = AimedRay.atClock(row).hit;
                    return Math.max(
                            share(row, hit.lambda(), "distance"),
                            Math.max(
                                    share(row, hit.hit.clockReading(), "reading"),
                                    share(row, hit.dopplerFactor(), "rate")));
                }))
                .matches(Worst::passes);
    }

    @Test
    void rodsAreMeasured() {
        assertThat(Worst.of(RODS, row -> {
                    Vector3d first = Vectors.unit(row.vector("end1_"))
                            .mul(AimedRay.atEnd(row, 1).hit.lambda());
                    Vector3d second = Vectors.unit(row.vector("end2_"))
                            .mul(AimedRay.atEnd(row, 2).hit.lambda());
                    return Math.max(
                            MovingQuantity.share(row, row.distance(first, "end1_"), "end1"),
                            Math.max(
                                    MovingQuantity.share(row, row.distance(second, "end2_"), "end2"),
                                    share(row, second.distance(first), "length")));
                }))
                .matches(Worst::passes);
    }

    @Test
    void eventsAndRaysGoIntoNestedFrames() {
        assertThat(Worst.of(NESTED, row -> {
                    Nested nested = new Nested(row);
                    Vector3d direction = new Vector3d(nested.ray.dx, nested.ray.dy, nested.ray.dz);
                    return Math.max(
                            Math.max(
                                    MovingQuantity.share(row, row.distance(nested.own.position(), "x2_"), "x2"),
                                    share(row, nested.own.time(), "t2")),
                            Math.max(
                                    MovingQuantity.share(row, row.distance(direction, "dir2_"), "dir2"),
                                    share(row, nested.ray.directionLength, "len2")));
                }))
                .matches(Worst::passes);
    }

    @Test
    void nestedVelocitiesCompose() {
        List<GoldenRow> rows =
                NESTED.stream().filter(row -> new Nested(row).motion != null).toList();
        assertThat(rows).hasSizeGreaterThan(30);
        assertThat(Worst.of(rows, row -> {
                    FrameMotion motion = new Nested(row).motion;
                    Vector3dc proper = FrameTree.motion(null, motion).inFirst();
                    return Math.max(
                            MovingQuantity.share(row, row.distance(proper, "u12_"), "u12"),
                            share(row, motion.gamma(), "g12"));
                }))
                .matches(Worst::passes);
    }

    private static Event event(GoldenRow row) {
        Vector3d x = row.vector("x_");
        return new Event(x.x, x.y, x.z, row.number("t"));
    }

    private static final class Nested {
        final Event own;
        final Ray ray;
        final FrameMotion motion;

        Nested(GoldenRow row) {
            Sphere ball = new Sphere("", new Vector3d(), 1, ColouredSurface.DEFAULT);
            MovingRow scene = MovingRow.of(
                    List.of(MovingRow.moving(
                            row.vector("v1_"),
                            row.vector("p1_"),
                            0,
                            MovingRow.moving(row.vector("v2_"), row.vector("p2_"), 0, ball))),
                    new Vector3d(),
                    Event.ORIGIN,
                    false);
            int frame = scene.world.frames().size() - 1;
            RestFrame rest = scene.world.objects(frame).primitives().get(0).restFrame();
            motion = rest.motion();
            own = rest.own(scene.routes.route(0, frame).transform(event(row)));
            Vector3d d = Vectors.unit(row.vector("d_"));
            ray = scene.routes.transform(Ray.from(0, 0, 0, d.x, d.y, d.z, 0), frame, Ray.blank());
        }
    }
}
