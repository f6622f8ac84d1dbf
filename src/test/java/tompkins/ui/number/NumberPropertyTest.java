package tompkins.ui.number;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import tompkins.sceneobject.Moving;
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

    @Test
    void theNumbersOfWhatMovesCanRun() {
        assertThat(NumberProperty.of(Studios.sphere().withScene(List.of(Moving.DEFAULT))))
                .extracting(NumberProperty::name)
                .contains("Scene \u203a moving \u203a Velocity", "Scene \u203a moving \u203a Place x")
                .contains("Scene \u203a moving \u203a Clock offset")
                .contains("Scene \u203a moving \u203a Objects \u203a sphere \u203a Radius");
    }
}
