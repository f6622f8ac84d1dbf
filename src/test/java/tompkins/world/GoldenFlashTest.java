package tompkins.world;

import static org.assertj.core.api.Assertions.assertThat;
import static tompkins.golden.GoldenTable.U;

import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import tompkins.golden.GoldenRow;
import tompkins.golden.GoldenTable;
import tompkins.golden.Worst;
import tompkins.light.Pulse;
import tompkins.light.Sightline;
import tompkins.ray.Hit;
import tompkins.sceneobject.Plane;
import tompkins.spacetime.Event;
import tompkins.surface.ColouredSurface;

/** Flashes of lamps against the reference data, row by row. */
class GoldenFlashTest {

    private static final List<GoldenRow> FLASHES = GoldenTable.rows("m10_flash");
    private static final List<GoldenRow> EXPOSURES = GoldenTable.rows("m10_exposure");

    /** Times in an exposure. */
    private static final int SAMPLES = 200;

    @Test
    void lightLeavesTheLampAtItsOwnTime() {
        assertThat(Worst.of(FLASHES, row -> {
                    double tau = new Flashed(row).sight.emission;
                    return MovingQuantity.share(row, row.difference(tau, "tau"), "tau");
                }))
                .matches(Worst::passes);
    }

    @Test
    void phaseOfTheFlash() {
        List<GoldenRow> rows = FLASHES.stream()
                .filter(row -> !row.isNumber("cycle") || row.number("decidable_eps") >= 16 * U)
                .toList();
        assertThat(Worst.of(rows, row -> {
                    Flashed flashed = new Flashed(row);
                    double cycle = row.isNumber("cycle") ? row.number("cycle") : 0;
                    return flashed.flash.cycle(flashed.sight.emission) != cycle
                            ? Double.POSITIVE_INFINITY
                            : MovingQuantity.share(
                                    row, row.difference(flashed.flash.phase(flashed.sight.emission), "phase"), "phase");
                }))
                .matches(Worst::passes);
    }

    @Test
    void lampIsOnAndOff() {
        assertThat(FLASHES)
                .filteredOn(row -> row.text("class").startsWith("exact") || row.number("decidable_eps") >= 16 * U)
                .hasSizeGreaterThan(50)
                .allSatisfy(row -> {
                    Flashed flashed = new Flashed(row);
                    assertThat(flashed.flash.isLit(flashed.sight.emission)).isEqualTo(row.has("lit", "1"));
                });
    }

    @Test
    void pointsAreLitFromTimeToTime() {
        assertThat(Worst.of(FLASHES, row -> {
                    LitSpan span = new Flashed(row).span();
                    double t = row.number("t");
                    return Math.max(
                            MovingQuantity.share(row, row.difference(t + span.from(), "t_on"), "t_on"),
                            MovingQuantity.share(row, row.difference(t + span.to(), "t_off"), "t_off"));
                }))
                .matches(Worst::passes);
    }

    @Test
    void beginningAndEndOfTheExposure() {
        assertThat(Worst.of(EXPOSURES, row -> {
                    Exposed exposed = new Exposed(row);
                    return Math.max(
                            MovingQuantity.share(row, row.difference(exposed.emission(0), "tau0"), "tau0"),
                            MovingQuantity.share(row, row.difference(exposed.emission(1), "tau1"), "tau1"));
                }))
                .matches(Worst::passes);
    }

    @Test
    void shareOfTheExposureIsLit() {
        assertThat(Worst.of(EXPOSURES, row -> {
                    Exposed exposed = new Exposed(row);
                    boolean isInstant = row.number("E") == 0;
                    int samples = isInstant ? 1 : SAMPLES;
                    int lit = 0;
                    for (int i = 0; i < samples; i++) {
                        lit += exposed.flash.isLit(exposed.emission((i + 0.5) / samples)) ? 1 : 0;
                    }
                    double limit = isInstant ? 1e-9 : 2 * row.number("intervals") / samples;
                    return Worst.share(row.difference((double) lit / samples, "share"), limit);
                }))
                .matches(Worst::passes);
    }

    @Test
    void litSpansOfTheExposure() {
        List<GoldenRow> rows =
                EXPOSURES.stream().filter(row -> row.isNumber("on1")).toList();
        assertThat(Worst.of(rows, row -> {
                    List<LitSpan> spans = new Exposed(row)
                            .spans().stream()
                                    .filter(span -> span.from() < row.number("E") && span.to() > 0)
                                    .toList();
                    double open = row.number("T");
                    double limit = 1e-12 * (row.number("E") + Math.abs(open));
                    double worst = row.isNumber("on2") && !row.isNumber("period") && spans.size() != 2
                            ? Double.POSITIVE_INFINITY
                            : 0;
                    for (int i = 0; i < Math.min(2, spans.size()); i++) {
                        double on = Math.max(0, spans.get(i).from());
                        double off = Math.min(row.number("E"), spans.get(i).to());
                        worst = Math.max(worst, row.difference(open + on, "on" + (i + 1)) / limit);
                        worst = Math.max(worst, row.difference(open + off, "off" + (i + 1)) / limit);
                    }
                    return worst;
                }))
                .matches(Worst::passes);
    }

    /** The light of the lamp of a row at an event on a surface that moves. */
    private static final class Flashed {
        final Pulse flash;
        final Sightline sight = new Sightline();
        final GoldenRow row;
        final MovingRow scene;
        final Event event;
        final int frame;

        Flashed(GoldenRow row) {
            this.row = row;
            flash = MovingRow.flash(row);
            scene = MovingRow.flashed(
                    row,
                    List.of(MovingRow.moving(
                            row.vector("vs_"), new Vector3d(), 0, plane(new Vector3d(), new Vector3d(0, 0, 1)))),
                    "p_",
                    new Vector3d(),
                    Event.ORIGIN);
            Vector3d x = row.vector("x_");
            event = new Event(x.x, x.y, x.z, row.number("t"));
            frame = row.vector("vs_").length() == 0 ? 0 : 1;
            Event there = scene.routes.route(0, frame).transform(event);
            Hit hit = Hit.blank();
            hit.setPlace(frame, there.x(), there.y(), there.z(), there.time());
            hit.eventMemory().setPlace(0, x.x, x.y, x.z, row.number("t"));
            if (!scene.retardedLight().find(0, hit, sight)) {
                throw new IllegalStateException("no light");
            }
        }

        /** When the point of the surface is lit, in scene time from the event. */
        LitSpan span() {
            double cycle = flash.cycle(sight.emission);
            int lightFrame = row.has("law", "galilean") ? scene.routes.camera() : 0;
            double begin = flash.start() + cycle * flash.period();
            Event shift = scene.routes.route(frame, lightFrame).worldLine();
            double speed = shift.position().length();
            List<LitSpan> spans = LitSpan.of(
                    emission(begin, lightFrame),
                    emission(begin + flash.duration(), lightFrame),
                    scene.routes.route(0, lightFrame).transform(event),
                    shift,
                    row.has("law", "galilean") ? (speed - 1) * (speed + 1) : -1);
            assertThat(spans).hasSize(1);
            double gamma = scene.routes.route(frame, 0).worldLine().time();
            return new LitSpan(gamma * spans.get(0).from(), gamma * spans.get(0).to());
        }

        /** What the lamp does at an own time, counted from where it passes its place. */
        private Event emission(double ownTime, int lightFrame) {
            Vector3d q = row.vector("q_");
            Vector3d p = row.vector("p_");
            Event inScene = new Event(p.x, p.y, p.z, 0)
                    .plus(scene.routes
                            .route(scene.world.lamps().get(0).frame(), 0)
                            .difference(new Event(q.x, q.y, q.z, ownTime)));
            return scene.routes.route(0, lightFrame).transform(inScene);
        }
    }

    private static Plane plane(Vector3d point, Vector3d normal) {
        return new Plane("", point, normal, ColouredSurface.DEFAULT);
    }

    /** The ray of a row while the shutter is open. */
    private static final class Exposed {
        final Pulse flash;
        private final GoldenRow row;
        private final MovingRow scene;

        Exposed(GoldenRow row) {
            this.row = row;
            flash = MovingRow.flash(row);
            scene = MovingRow.flashed(
                    row,
                    List.of(MovingRow.moving(
                            row.vector("vw_"), row.vector("pw_"), 0, plane(row.vector("q1_"), row.vector("q2_")))),
                    "pl_",
                    row.vector("beta_"),
                    Event.ORIGIN);
        }

        private FoundHit hit(double part) {
            Vector3d o = row.vector("o_");
            Event camera = new Event(o.x, o.y, o.z, row.number("T") + part * row.number("E"));
            return scene.find(scene.inScene(camera, row.vector("d_"), false));
        }

        /** Own time of the lamp after a part of the exposure. */
        double emission(double part) {
            Sightline sight = new Sightline();
            if (!scene.retardedLight().find(0, hit(part).hit, sight)) {
                throw new IllegalStateException("no light");
            }
            return sight.emission;
        }

        /** When the hit is lit by the flash of the first lit interval, counted from the beginning of the exposure. */
        List<LitSpan> spans() {
            FoundHit first = hit(0);
            double cycle = flash.cycle(emission((row.number("on1") - row.number("T")) / row.number("E") + 1e-6));
            return new FlashTimes(scene.world, scene.routes, scene.law).of(0, flash, cycle, first.ray, first.hit);
        }
    }
}
