package tompkins.ui.number;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Sphere;
import tompkins.studio.Studio;
import tompkins.studio.StudioNumber;
import tompkins.studio.Studios;

class NumberPropertyTest {

    @Test
    void everyNumberOfTheSceneCanRun() {
        List<NumberProperty> properties = NumberProperty.of(Studios.sphere());
        NumberProperty radius = properties.stream()
                .filter(property -> property.name().equals("Scene \u203a sphere \u203a Radius"))
                .findFirst()
                .orElseThrow();
        Studio larger = radius.number().with(Studios.sphere(), 2);
        assertThat(((Sphere) larger.scene().get(0)).radius()).isEqualTo(2);
        for (NumberProperty property : properties) {
            double value = property.number().in(Studios.sphere());
            Studio same = property.number().with(Studios.sphere(), value);
            assertThat(property.number().in(same)).as(property.name()).isEqualTo(value);
        }
    }

    @Test
    void theNumbersOfWhatMovesCanRun() {
        Studio studio = Studios.sphere().withScene(List.of(Moving.DEFAULT));
        assertThat(NumberProperty.of(studio))
                .extracting(NumberProperty::name)
                .contains(
                        "Scene \u203a moving \u203a Velocity",
                        "Scene \u203a moving \u203a Place x",
                        "Scene \u203a moving \u203a Clock offset",
                        "Scene \u203a moving \u203a Objects \u203a sphere \u203a Radius");
    }

    @Test
    void everyNumberIsCalledAsItIsOffered() {
        for (NumberProperty property : NumberProperty.of(Studios.sphere())) {
            assertThat(NumberProperty.of(property.number(), Studios.sphere())).isEqualTo(property);
        }
        StudioNumber gamma = StudioNumber.at("velocity.gamma", Studios.lattice());
        assertThat(NumberProperty.of(gamma, Studios.lattice()).name()).isEqualTo("velocity.gamma");
    }
}
