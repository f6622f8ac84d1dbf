package tompkins.ui.number;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import tompkins.studio.StudioNumber;
import tompkins.studio.Studios;

class NumberPropertyTest {

    @Test
    void everyNumberIsCalledAsItIsOffered() {
        for (NumberProperty property : NumberProperty.of(Studios.sphere())) {
            assertThat(NumberProperty.of(property.number(), Studios.sphere())).isEqualTo(property);
        }
        StudioNumber gamma = StudioNumber.at("velocity.gamma", Studios.lattice());
        assertThat(NumberProperty.of(gamma, Studios.lattice()).name()).isEqualTo("velocity.gamma");
    }
}
