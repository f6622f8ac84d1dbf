package tompkins.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;

class MeasuredTest {

    private static Measured measured(Quantity... quantities) {
        return new Measured(List.of(quantities), null, List.of());
    }

    /** 6 +- 0.3 to 2 +- 0.08: 5 and 4 percent together are sqrt(41) percent. */
    @Test
    void uncertaintiesOfBothCount() {
        Measured here = measured(new Quantity("cameraAngle", "", "degrees", 6, 0.3));
        Measured there = measured(new Quantity("cameraAngle", "", "degrees", 2, 0.08));

        Quantity ratio = here.ratiosTo(there).get("cameraAngle");

        assertThat(ratio.key()).isEqualTo("cameraAngle");
        assertThat(ratio.unit()).isEmpty();
        assertThat(ratio.value()).isCloseTo(3, within(1e-15));
        assertThat(ratio.uncertainty()).isCloseTo(3 * Math.sqrt(41) / 100, within(1e-15));
    }

    @Test
    void onlySizesOfBothAreCompared() {
        Measured here = measured(
                Quantity.exact("sceneTime", "", "scene units", 4),
                Quantity.exact("length", "", "degrees", 4),
                Quantity.exact("sceneDistance", "", "scene units", 1),
                new Quantity("axisAngle", "", "degrees", 40, 1));
        Measured there = measured(
                Quantity.exact("sceneTime", "", "scene units", 2),
                Quantity.exact("length", "", "degrees", 0),
                new Quantity("axisAngle", "", "degrees", 20, 1));

        assertThat(here.ratiosTo(there)).isEmpty();
    }
}
