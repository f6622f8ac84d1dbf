package tompkins.shutter;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.golden.Worst;

/** The time of every shutter model against the reference data, row by row. */
class GoldenShuttersTest {

    @ParameterizedTest
    @ValueSource(
            strings = {
                "aperture_plane",
                "arbitrary_plane",
                "detector_hologram",
                "detector_ideal",
                "detector_infinity",
                "fixed_point",
                "focus_surface"
            })
    void programPassesEveryRow(String model) {
        assertThat(GoldenShutters.worst(model)).matches(Worst::passes);
    }
}
