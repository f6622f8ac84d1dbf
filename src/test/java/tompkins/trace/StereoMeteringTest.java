package tompkins.trace;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.io.StudioReader;

/** Light that motion changes is metered from between the eyes, so that both pictures have one exposure. */
class StereoMeteringTest {

    /** Straight ahead of a camera that moves that way with 0.6 c the Doppler factor is 2, whatever the eyes see. */
    @ParameterizedTest
    @ValueSource(strings = {"none", "left-eye", "right-eye", "side-by-side", "anaglyph"})
    void isThatBetweenTheEyes(String layout) {
        RenderPlan plan = RenderPlan.of(StudioReader.read(
                "{\"velocity\": [0, 0, 0.6], \"colours\": \"doppler\", \"camera\": {\"stereo\": {\"layout\": \""
                        + layout
                        + "\", \"eyeDistance\": 3, \"zeroParallaxDistance\": 3}},"
                        + " \"settings\": {\"width\": 8, \"height\": 6}}",
                "stereo",
                Path.of(".")));
        assertThat(plan.lightShift().middle()).isCloseTo(2, within(1e-12));
    }
}
