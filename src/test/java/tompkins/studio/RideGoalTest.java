package tompkins.studio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import tompkins.property.InvalidPropertyException;
import tompkins.spacetime.Velocity;

/** When a ride meets a challenge, with the closed formulas of uniform and of hyperbolic motion. */
class RideGoalTest {

    private static final double ANY = 1e9;

    /** gamma = 1.25: on board 0.8 of the time of the scene. */
    private static final RideMoment START = RideMoment.start(Studio.DEFAULT.withVelocity(Velocity.of(0, 0, 0.6)));

    private static ChallengeProgress flown(RideMoment start, RideMoment end, RideGoal... goals) {
        return new ChallengeProgress(List.of(goals), 0).after(start, end);
    }

    private static RideGoal at(double z, double latest, double younger) {
        return new RideGoal(new Vector3d(0.3, 0, z), 0.31, 1, ANY / 10, latest, younger);
    }

    /** In 4 on board, 5 in the scene, it flies over 3. */
    @Test
    void aPlaceIsReachedBetweenTwoMoments() {
        RideMoment end = START.after(new Vector3d(), 4);

        assertThat(flown(START, end, at(1.5, ANY, 0)).isMet()).isTrue();
        assertThat(flown(START, end, at(3.05, ANY, 0)).isMet()).isTrue();
        assertThat(flown(START, end, at(3.1, ANY, 0)).isMet()).isFalse();
        assertThat(flown(START, end, at(-0.1, ANY, 0)).isMet()).isFalse();
    }

    @Test
    void clocksDecide() {
        RideMoment end = START.after(new Vector3d(), 4);

        assertThat(flown(START, end, at(1, 4.001, 0.999)).isMet()).isTrue();
        assertThat(flown(START, end, at(1, 3.999, 0.999)).isMet()).isFalse();
        assertThat(flown(START, end, at(1, 3.999, 0.999)).isLost(end)).isTrue();
        assertThat(flown(START, end, at(1, 4.001, 1.001)).isMet()).isFalse();
    }

    /** From rest with acceleration 1 over 2: gamma = 1 + 2. */
    @Test
    void speedDecidesAndGoalsFollowEachOther() {
        RideMoment rest = RideMoment.start(Studio.DEFAULT);
        RideMoment fast = rest.after(new Vector3d(0, 0, 1), Math.log(3 + Math.sqrt(8)));
        RideGoal gate = new RideGoal(new Vector3d(0, 0, 2), 1e-6, 2.9999, ANY / 10, ANY, 0);
        RideGoal stop = new RideGoal(new Vector3d(0, 0, 2), 3, 1, 1.001, ANY, 0);

        ChallengeProgress through = flown(rest, fast, gate, stop);
        assertThat(through.reached()).isEqualTo(1);
        assertThat(flown(rest, fast, stop, gate).reached()).isZero();
        RideMoment stopped = fast.after(fast.brake(1), fast.rider().rapidity());
        assertThat(through.after(fast, stopped).isMet()).isTrue();
        assertThat(ChallengeProgress.NONE.isMet()).isFalse();
    }

    @Test
    void impossibleSpeedsAreRefused() {
        assertThatThrownBy(() -> new RideGoal(new Vector3d(), 1, 3, 2, 1, 0))
                .isInstanceOf(InvalidPropertyException.class)
                .hasMessageContaining("mostGamma must be at least leastGamma, was 2");
    }
}
