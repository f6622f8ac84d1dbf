package tompkins.scenes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.animation.RideFilm;
import tompkins.spacetime.Event;
import tompkins.spacetime.Velocity;
import tompkins.studio.LensEvent;
import tompkins.studio.RideMoment;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;

class TownSquareTest {

    private static final int HEIGHT = 3000;

    /** The clock on the front of the tower, as the scene file says: height over the lens, distance and radius. */
    private static final double CLOCK_HEIGHT = 2.35;

    private static final double CLOCK_DISTANCE = 8.225;
    private static final double CLOCK_RADIUS = 0.525;

    /** The places on the middle column of the picture at which the clock is seen, as tangents above the middle. */
    private static List<Double> clock(Studio studio) {
        RenderPlan plan = RenderPlan.of(studio.withSettings(studio.settings().withSize(4 * HEIGHT / 3, HEIGHT)));
        double edge = 0.75 * Math.tan(Math.toRadians(37.5));
        List<Double> places = new ArrayList<>();
        for (int row = 0; row < HEIGHT; row++) {
            SampleHistory life = SampleHistory.of(plan, 2.0 * HEIGHT / 3, row + 0.5, 0, 0);
            if (life != null
                    && life.end() != null
                    && life.end().object().description().equals("clock, front")) {
                places.add(edge * (1 - 2 * (row + 0.5) / HEIGHT));
            }
        }
        return places;
    }

    /** tan(a'/2) = tan(a/2) sqrt((1 - beta)/(1 + beta)), a third at 0.8. */
    private static double seen(double height, double beta) {
        double half = Math.tan(Math.atan2(height, CLOCK_DISTANCE) / 2) * Math.sqrt((1 - beta) / (1 + beta));
        return Math.tan(2 * Math.atan(half));
    }

    @ParameterizedTest
    @CsvSource({"0", "0.8"})
    void theClockIsSeenWhereAberrationTakesIt(double beta) {
        List<Double> places = clock(SceneFiles.read("town-square").withVelocity(Velocity.of(0, 0, beta)));

        double pixel = 1e-3;
        assertThat(places.get(0)).isCloseTo(seen(CLOCK_HEIGHT + CLOCK_RADIUS, beta), within(pixel));
        assertThat(places.get(places.size() - 1)).isCloseTo(seen(CLOCK_HEIGHT - CLOCK_RADIUS, beta), within(pixel));
    }

    /** Places by the formulas of constant proper acceleration, from beta 0.8 to rest and to rapidity 1.6. */
    @ParameterizedTest
    @CsvSource({"0, 0, 0.8", "0.5, 0.6667, 0.8", "3, 2, 0", "6.6, 5.1549, 0.9217", "9, 10.8564, 0.9217"})
    void theRideBrakesAndGoesThroughTheGate(double seconds, double place, double beta) {
        RideMoment moment = new RideFilm(SceneFiles.read("town-square")).moment(seconds);

        Event lens = LensEvent.inScene(moment.studio());
        assertThat(lens.position().distance(0, 0, place)).isLessThan(1e-3);
        assertThat(moment.studio().velocity().speed()).isCloseTo(beta, within(1e-4));
    }

    /** The tower stands from 8.25 to 9.85. */
    @Test
    void nothingIsInTheWayOfTheRide() {
        Studio rest = SceneFiles.read("town-square").withVelocity(Velocity.of(new Vector3d()));

        SampleHistory ahead = SampleHistory.of(RenderPlan.of(rest), 320, 240, 0, 0);

        assertThat(ahead.end() == null || ahead.end().event().z() > 10.8564).isTrue();
    }
}
