package tompkins.scenes;

import static org.assertj.core.api.Assertions.as;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.InstanceOfAssertFactories.STRING;

import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.explain.Explanation;
import tompkins.explain.Flashes;
import tompkins.studio.Studio;
import tompkins.trace.FlashSight;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;
import tompkins.world.LitSpan;

/** The scenes with light in flight show what their remarks say. */
class FlashScenesTest {

    /** Each opening time lies where something is lit; just before the first light nothing is, and just after it is. */
    @ParameterizedTest
    @ValueSource(strings = {"rings", "train", "train-aboard", "own-lamp", "echo"})
    void isTakenWhileSomethingIsLit(String name) throws IOException {
        Studio studio = SceneFiles.read("flash-" + name);
        RenderPlan plan = RenderPlan.of(studio);
        LitSpan times = new Flashes(plan).litTimes().orElseThrow();

        assertThat(new Explanation(plan).warnings()).isEmpty();
        assertThat(studio.camera().shutter().openingTime()).isBetween(times.from(), times.to());
        if (name.equals("train")) {
            // it was elsewhere then, and its times are judged by where it is now
            return;
        }
        assertThat(new Explanation(opened(studio, times.from() - 0.001)).warnings())
                .singleElement(as(STRING))
                .startsWith("no flash lights anything");
        assertThat(new Explanation(opened(studio, times.from() + 0.001)).warnings())
                .isEmpty();
    }

    private static RenderPlan opened(Studio studio, double time) {
        return RenderPlan.of(studio.withCamera(
                studio.camera().withShutter(studio.camera().shutter().openedAt(time))));
    }

    /** On board the middle of the train is lit by both lamps at once; so it is in the picture of the embankment. */
    @ParameterizedTest
    @CsvSource({"train, 10.8", "train-aboard, 10.05"})
    void bothFlashesMeetInTheMiddle(String name, double opened) throws IOException {
        Studio studio = SceneFiles.read("flash-" + name);
        List<FlashSight> flashes = post(opened(studio, opened)).flashes();

        assertThat(flashes).hasSize(2).allMatch(FlashSight::isLit);
        assertThat(flashes.get(0).emission()).isCloseTo(flashes.get(1).emission(), within(0.1));
    }

    /** What is lit lies between two ellipsoids around star and camera. */
    @Test
    void theLightEchoIsARing() throws IOException {
        RenderPlan plan = RenderPlan.of(SceneFiles.read("flash-echo"));
        int lit = 0;
        double largest = 0;
        for (double x = 0.5; x < plan.width(); x++) {
            double radius = 2002 * Math.tan(Math.toRadians(0.2)) * Math.abs(2 * x / plan.width() - 1);
            SampleHistory.Encounter seen =
                    SampleHistory.of(plan, x, plan.height() / 2.0, 0, 0).end();
            boolean isDust = radius > 0.122;
            assertThat(seen.object().description()).isEqualTo(isDust ? "dust" : "star");
            if (isDust) {
                double way = Math.hypot(radius, 2) + Math.hypot(radius, 2002);
                boolean isLit = seen.flashes().get(0).isLit();
                assertThat(isLit).as("at radius %s", radius).isEqualTo(way > 2006.6 && way < 2007);
                lit += isLit ? 1 : 0;
                largest = isLit ? Math.max(largest, radius) : largest;
            }
        }
        // Fact 4 of light in flight: a camera far away sees the radius of the remarks
        assertThat(largest).isCloseTo(Math.sqrt(21), within(0.03));
        assertThat(lit).isGreaterThan(20);
    }

    /** The times are far from zero and close to each other. */
    @Test
    void timesOfTheLightEchoAreToldApart() throws IOException {
        assertThat(new Explanation(opened(SceneFiles.read("flash-echo"), 100)).warnings())
                .singleElement(as(STRING))
                .contains("from 2004.0", "to 2010.");
    }

    private static SampleHistory.Encounter post(RenderPlan plan) {
        for (double x = 0.5; x < plan.width(); x++) {
            SampleHistory.Encounter seen =
                    SampleHistory.of(plan, x, 0.52 * plan.height(), 0, 0).end();
            if (seen != null && seen.object().description().equals("middle of the train")) {
                return seen;
            }
        }
        throw new AssertionError("no post is seen");
    }
}
