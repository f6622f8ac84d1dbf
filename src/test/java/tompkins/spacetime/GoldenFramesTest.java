package tompkins.spacetime;

import static org.assertj.core.api.Assertions.assertThat;
import static tompkins.golden.GoldenTable.U;

import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import tompkins.golden.GoldenRow;
import tompkins.golden.GoldenTable;
import tompkins.golden.Worst;
import tompkins.ray.Ray;

/** Changes of frame against the reference data, row by row. */
class GoldenFramesTest {

    private static final List<GoldenRow> EVENTS = GoldenTable.rows("a_events_directions");
    private static final List<GoldenRow> ANGLES = GoldenTable.rows("e_doppler_aberration");
    private static final List<GoldenRow> OUTLINES = GoldenTable.rows("d_sphere_outlines");

    @ParameterizedTest
    @EnumSource
    void programPassesEveryRow(FrameQuantity quantity) {
        assertThat(quantity.worst(FrameMethod.PROGRAM)).matches(Worst::passes);
    }

    @Test
    void inverseIsTheTransformationWithTheOppositeVelocity() {
        assertThat(EVENTS).allSatisfy(row -> {
            Velocity velocity = Velocity.of(row.vector("beta_", "_hex"));
            Event event = new Event(row.number("x"), row.number("y"), row.number("z"), row.number("t"));
            assertThat(new LorentzTransformation(velocity).inverse().transform(event))
                    .isEqualTo(new LorentzTransformation(
                                    Velocity.of(velocity.given().negate(new Vector3d())))
                            .transform(event));
        });
    }

    @Test
    void directionsThatRaysKeepAreNull() {
        Worst worst = Worst.of(EVENTS, row -> {
            Vector3d d = row.vector("d").normalize();
            Ray ray = Ray.from(0, 0, 0, d.x, d.y, d.z, 0);
            Ray turned = new LorentzTransformation(Velocity.of(row.vector("beta_", "_hex"))).transform(ray);
            double length = Math.sqrt(turned.dx * turned.dx + turned.dy * turned.dy + turned.dz * turned.dz);
            return Math.abs(length - 1) / (16 * U * row.number("gamma"));
        });
        assertThat(worst).matches(Worst::passes);
    }

    @Test
    void dopplerFactorAtAnAngle() {
        assertThat(Worst.of(ANGLES, row -> dopplerExcess(row, 1 / turned(row, new Vector3d()))))
                .matches(Worst::passes);
    }

    private static double dopplerExcess(GoldenRow row, double factor) {
        return row.relativeDifference(factor, "doppler_cam_over_scene")
                / (8 * U * (1 + row.number("cond_doppler_theta")));
    }

    @Test
    void sceneAngleAtAnAngle() {
        assertThat(Worst.of(ANGLES, row -> {
                    Vector3d direction = new Vector3d();
                    turned(row, direction);
                    return angleExcess(row, Math.atan2(direction.x, direction.z));
                }))
                .matches(Worst::passes);
    }

    private static double angleExcess(GoldenRow row, double angle) {
        return Worst.share(row.difference(angle, "theta_scene"), 8 * U * row.number("theta_scene"));
    }

    /** The direction at the row's angle from the velocity, seen from the scene. */
    private static double turned(GoldenRow row, Vector3d result) {
        double angle = row.number("theta_cam");
        Velocity velocity = Velocity.of(0, 0, row.number("beta_hex"));
        return new LorentzTransformation(velocity).direction(new Vector3d(Math.sin(angle), 0, Math.cos(angle)), result);
    }

    @Test
    void velocityKnowsItsOtherScales() {
        Worst worst = Worst.of(ANGLES, row -> {
            Velocity velocity = Velocity.of(0, 0, row.number("beta_hex"));
            double error = Math.max(
                    relative(row, velocity.properSpeed(), "gamma_beta"),
                    Math.max(
                            relative(row, velocity.expMinusRapidity(), "exp_minus_rapidity"),
                            relative(row, velocity.rapidity(), "rapidity")));
            return error / (8 * U);
        });
        assertThat(worst).matches(Worst::passes);
    }

    private static double relative(GoldenRow row, double value, String column) {
        return row.difference(value, column) == 0 ? 0 : row.relativeDifference(value, column);
    }

    /**
     * A circle of directions n . d = cos(a) is the plane of a 4-vector (n, cos(a)), which changes its frame as an event
     * does: Penrose's circle without a formula of its own.
     */
    @Test
    void outlineOfASphereIsACircle() {
        Worst worst = Worst.of(OUTLINES, row -> {
            LorentzTransformation cameraFromScene =
                    new LorentzTransformation(Velocity.of(row.vector("beta_", "_hex"))).inverse();
            double angle = row.number("alpha_scene");
            Vector3d towards = row.vector("Ch");
            Event circle = cameraFromScene.transform(new Event(-towards.x, -towards.y, -towards.z, Math.cos(angle)));
            Vector3d centre = circle.position().negate().normalize();
            double radius = Math.atan2(Math.sin(angle), circle.time());
            return Math.max(
                    row.distance(centre, "ctr_") / (4 * U * row.number("acond_centre")),
                    row.difference(radius, "rho") / (4 * U * row.number("acond_rho")));
        });
        assertThat(worst).matches(Worst::passes);
    }

    @Test
    void raysOnTheOutlineTouchTheSphere() {
        assertThat(Worst.of(OUTLINES, GoldenFramesTest::tangency)).matches(Worst::passes);
    }

    /** By how much the traced ray of each reference direction misses the sphere's surface. */
    private static double tangency(GoldenRow row) {
        Vector3d beta = row.vector("beta_", "_hex");
        Event start = FrameMethod.PROGRAM.event(
                beta, new Event(row.number("ox"), row.number("oy"), row.number("oz"), row.number("t0")));
        Vector3d toCentre = row.vector("C").sub(start.position());
        double worst = 0;
        for (int corner = 0; corner < 4; corner++) {
            Vector3d direction = new Vector3d();
            FrameMethod.PROGRAM.direction(beta, row.vector("p" + corner), direction);
            double miss = Math.abs(toCentre.cross(direction, new Vector3d()).length() - row.number("R"));
            worst = Double.isNaN(miss) ? miss : Math.max(worst, miss);
        }
        double scale = row.vector("o").length() + Math.abs(row.number("t0")) + toCentre.length();
        return worst / (8 * U * Velocity.of(beta).gamma() * scale);
    }
}
