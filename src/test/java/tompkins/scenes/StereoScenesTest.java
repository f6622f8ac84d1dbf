package tompkins.scenes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.trace.RayLife;
import tompkins.trace.RenderPlan;

/** The examples with two eyes, by what the centres of balls look like in the pictures of both. */
class StereoScenesTest {

    /** Pixels for a slope of 1 in each half of the pair, which is 400 wide and sees 30 degrees. */
    private static final double FOCAL_LENGTH = 200 / Math.tan(Math.toRadians(15));

    /** A ball so small that only a ray to its centre meets it. */
    private static RenderPlan withPoint(Studio studio, Vector3dc centre) {
        Sphere ball = new Sphere("point", centre, 1e-9, ((Sphere) studio.scene().get(1)).surface());
        return RenderPlan.of(studio.withScene(List.of(ball)));
    }

    private static boolean meets(RenderPlan plan, double column, double row) {
        RayLife life = RayLife.of(plan, column, row, 0, 0);
        return life.end() != null;
    }

    /** At 0.8 c the ball 4 ahead has no parallax; at rest it has f s (1/12 - 1/4). */
    @Test
    void fastEyesSeeTheBallThreeTimesAsFar() {
        Studio pair = SceneFiles.read("stereo-pair");
        Sphere ball = (Sphere) pair.scene().get(1);
        assertThat(ball.centre()).isEqualTo(new Vector3d(0, 0, 4));
        double depth = 5 / 3.0 * (4 + 0.8 * Math.hypot(4, 0.15));
        assertThat(depth).isCloseTo(12, within(0.004));
        assertBothMeet(pair, ball, FOCAL_LENGTH * 0.3 * (1 / 12.0 - 1 / depth));
        assertBothMeet(pair.withVelocity(Velocity.REST), ball, FOCAL_LENGTH * 0.3 * (1 / 12.0 - 1 / 4.0));
    }

    private static void assertBothMeet(Studio pair, Sphere ball, double disparity) {
        RenderPlan plan = withPoint(pair, ball.centre());
        assertThat(meets(plan, 200 - disparity / 2, 200)).isTrue();
        assertThat(meets(plan, 600 + disparity / 2, 200)).isTrue();
        assertThat(meets(plan, 600 + disparity / 2 + 1e-3, 200)).isFalse();
    }

    /** The ball ahead lies at asin(0.15/3) to the right for the left eye, before aberration. */
    @Test
    void eyesOfThePanoramaSeeTheBallAheadApart() {
        Studio panorama = SceneFiles.read("stereo-panorama").withVelocity(Velocity.REST);
        RenderPlan plan = withPoint(panorama, ((Sphere) panorama.scene().get(1)).centre());
        double columns = 2 * Math.toDegrees(Math.asin(0.15 / 3));
        assertThat(meets(plan, 360 + columns, 180)).isTrue();
        assertThat(meets(plan, 360 - columns, 540)).isTrue();
        assertThat(meets(plan, 360 - columns, 180)).isFalse();
    }
}
