package tompkins.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.golden.GoldenRow;
import tompkins.golden.GoldenTable;
import tompkins.math.Vectors;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.world.FrameAppearance;

/** Circles of directions as a moving camera sees them, against the reference outlines of spheres and closed forms. */
class LookConeTest {

    private static FrameAppearance frame(Velocity velocity) {
        return new FrameAppearance(Studio.DEFAULT.withVelocity(velocity), null);
    }

    /** Every direction of the outline is seen on the circle of the row. */
    @Test
    void outlinesOfSpheresAreTheReferenceCircles() {
        assertThat(GoldenTable.rows("d_sphere_outlines").size()).isGreaterThan(30);
        for (GoldenRow row : GoldenTable.rows("d_sphere_outlines")) {
            Velocity velocity = Velocity.of(row.vector("beta_", "_hex"));
            LookCone outline = LookCone.outline(row.vector("P"), row.vector("C"), row.number("R"));

            // cond: what a rounding of the numbers of the row does to the result
            double rounding = 1e-15 * (10 + velocity.gamma() * velocity.gamma());
            double size = 1 + row.vector("P").length() / row.number("R");
            for (double azimuth = 0; azimuth < 6.3; azimuth += 0.7) {
                Vector3d seen = frame(velocity).look(outline.direction(azimuth));
                assertThat(Angles.between(row.vector("ctr_"), seen) - row.number("rho"))
                        .as(row.id())
                        .isCloseTo(0, within(rounding * size));
            }
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.3, 0.8, 0.995})
    void circlesAboutTheMotionFollowAberration(double beta) {
        Velocity velocity = Velocity.of(SpeedScale.BETA, beta, new Vector3d(1, 2, -2));
        for (int degrees = 10; degrees < 180; degrees += 10) {
            double cosine = Math.cos(Math.toRadians(degrees));
            LookCone circle = LookCone.around(velocity.direction(), Math.toRadians(degrees));

            assertThat(frame(velocity).look(circle.direction(degrees)).dot(velocity.direction()))
                    .isCloseTo((cosine + beta) / (1 + beta * cosine), within(1e-13));
        }
        // the horizon of aberration lies at arccos beta
        LookCone across = LookCone.across(velocity.direction());
        assertThat(Angles.between(velocity.direction(), frame(velocity).look(across.direction(1))))
                .isCloseTo(Math.acos(beta), within(1e-13));
    }

    /** A rod is seen straight if and only if the plane of pinhole and rod holds the motion. */
    @Test
    void rodsLookStraightInThePlaneOfTheMotionOnly() {
        FrameAppearance frame = frame(Velocity.of(0.6, 0, 0.3));
        Vector3d along = new Vector3d(1, 1, 0);
        Vector3d through = new Vector3d(0.6, 0, 0.3).mul(4).fma(2, along);

        assertThat(bend(frame, through, along)).isLessThan(1e-13);
        assertThat(bend(frame, through.add(0, 0, 0.1), along)).isGreaterThan(1e-5);
    }

    /** How far the direction of a point of a rod is from the great circle through those of two others. */
    private static double bend(FrameAppearance frame, Vector3d through, Vector3d along) {
        Vector3d first = frame.look(through);
        Vector3d middle = frame.look(new Vector3d(through).fma(1, along));
        Vector3d last = frame.look(new Vector3d(through).fma(2, along));
        return Math.abs(middle.dot(Vectors.unit(Vectors.cross(first, last))));
    }

    @Test
    void nobodySeesTheOutlineOfASphereFromInside() {
        assertThat(LookCone.outline(new Vector3d(0, 0, 1), new Vector3d(), 1.5)).isNull();
    }
}
