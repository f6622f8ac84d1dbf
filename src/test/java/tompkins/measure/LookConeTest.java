package tompkins.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.golden.GoldenRow;
import tompkins.golden.GoldenTable;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;

/** Circles of directions, against the reference outlines of spheres and closed forms. */
class LookConeTest {

    @Test
    void outlinesOfSpheresAreTheReferenceCircles() {
        assertThat(GoldenTable.rows("d_sphere_outlines").size()).isGreaterThan(30);
        for (GoldenRow row : GoldenTable.rows("d_sphere_outlines")) {
            Velocity velocity = Velocity.of(row.vector("beta_", "_hex"));
            LookCone scene = LookCone.outline(row.vector("P"), row.vector("C"), row.number("R"));
            LookCone seen = scene.seenBy(velocity);

            // cond: what a rounding of the numbers of the row does to the result
            double rounding = 1e-15 * (10 + velocity.gamma() * velocity.gamma());
            double size = 1 + row.vector("P").length() / row.number("R");
            assertThat(seen.halfAngle() / row.number("rho")).as(row.id()).isCloseTo(1, within(rounding * size));
            assertThat(Angles.between(seen.axis(), row.vector("ctr_")))
                    .as(row.id())
                    .isLessThan(rounding * size);
            for (String point : new String[] {"p0", "p1", "p2", "p3"}) {
                assertThat(Angles.between(seen.axis(), row.vector(point)) - row.number("rho"))
                        .as(row.id())
                        .isCloseTo(0, within(rounding * size));
            }
        }
    }

    /** Lesson of the Penrose sphere: cot d' = gamma (cos d + beta cos A)/sin d at A = 90 degrees. */
    @Test
    void sphereAcrossTheMotionLooksSmaller() {
        Velocity velocity = Velocity.of(0, 0, 0.8);
        LookCone seen =
                LookCone.outline(new Vector3d(), new Vector3d(10, 0, 0), 1).seenBy(velocity);

        assertThat(Math.toDegrees(seen.halfAngle())).isCloseTo(3.4509, within(5e-5));
        assertThat(Math.toDegrees(Angles.between(seen.axis(), new Vector3d(0, 0, 1))))
                .isCloseTo(37.0082, within(5e-5));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.3, 0.8, 0.995})
    void circlesAboutTheMotionFollowAberration(double beta) {
        Velocity velocity = Velocity.of(SpeedScale.BETA, beta, new Vector3d(1, 2, -2));
        for (int degrees = 10; degrees < 180; degrees += 10) {
            double cosine = Math.cos(Math.toRadians(degrees));
            LookCone seen = LookCone.around(velocity.direction(), Math.toRadians(degrees))
                    .seenBy(velocity);

            assertThat(Math.cos(seen.halfAngle())).isCloseTo((cosine + beta) / (1 + beta * cosine), within(1e-13));
        }
        // the horizon of aberration lies at arccos beta
        assertThat(LookCone.across(velocity.direction()).seenBy(velocity).halfAngle())
                .isCloseTo(Math.acos(beta), within(1e-13));
    }

    /** A rod is seen straight if and only if the plane of pinhole and rod holds the motion. */
    @Test
    void rodsLookStraightInThePlaneOfTheMotionOnly() {
        Velocity velocity = Velocity.of(0.6, 0, 0.3);
        Vector3d from = new Vector3d(1, 2, 3);
        Vector3d along = new Vector3d(1, 1, 0);
        Vector3d through = new Vector3d(velocity.direction()).mul(4).add(from).fma(2, along);

        assertThat(LookCone.line(from, through, along).seenBy(velocity).isStraight())
                .isTrue();
        assertThat(LookCone.line(from, through.add(0, 0, 0.1), along)
                        .seenBy(velocity)
                        .isStraight())
                .isFalse();
        assertThat(LookCone.line(from, new Vector3d(from).fma(3, along), along)).isNull();
    }

    @Test
    void directionsLieOnTheCircleAndTurnWithIt() {
        Velocity velocity = Velocity.of(0.2, -0.1, 0.97);
        LookCone scene = LookCone.outline(new Vector3d(), new Vector3d(1, 2, 5), 0.7);
        LookCone seen = scene.seenBy(velocity);
        SeenFrame frame = new SeenFrame(Studio.DEFAULT.withVelocity(velocity), null);

        for (double azimuth = 0; azimuth < 6.3; azimuth += 0.3) {
            assertThat(Angles.between(seen.axis(), seen.direction(azimuth))).isCloseTo(seen.halfAngle(), within(1e-13));
            assertThat(Angles.between(seen.axis(), frame.look(scene.direction(azimuth))))
                    .isCloseTo(seen.halfAngle(), within(1e-13));
        }
        assertThat(seen.axis().lengthSquared() - seen.cosine() * seen.cosine())
                .isCloseTo(scene.axis().lengthSquared() - scene.cosine() * scene.cosine(), within(1e-13));
    }

    @Test
    void nobodySeesTheOutlineOfASphereFromInside() {
        assertThat(LookCone.outline(new Vector3d(0, 0, 1), new Vector3d(), 1.5)).isNull();
    }
}
