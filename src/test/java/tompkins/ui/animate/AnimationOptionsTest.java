package tompkins.ui.animate;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Container;
import javax.swing.JTextField;
import org.junit.jupiter.api.Test;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.ui.Components;
import tompkins.ui.LightLook;

@LightLook
class AnimationOptionsTest {

    private final Studio studio =
            Studios.sphere().withSettings(Studios.sphere().settings().withSize(640, 480));
    private final AnimationOptions options = new AnimationOptions(studio, rate -> 4 * rate);
    private final Container panel = (Container) options.component();

    @Test
    void theUsualAnswersAreThoseOfTheScene() {
        assertThat(options.studio()).isEqualTo(studio);
        assertThat(options.frameRate()).isEqualTo(25);
        assertThat(Components.notes(panel)).contains("100 pictures of 640 \u00d7 480 pixels");
    }

    @Test
    void picturesASecondAndSizeAreTaken() {
        Components.enter(panel, "Pictures a second", "50");
        Components.enter(panel, "Width", "320");
        assertThat(Components.find(panel, JTextField.class, "Height").getText()).isEqualTo("240");
        assertThat(Components.notes(panel)).contains("200 pictures of 320 \u00d7 240 pixels");
        Components.enter(panel, "Height", "720");
        assertThat(options.frameRate()).isEqualTo(50);
        assertThat(options.studio().settings()).isEqualTo(studio.settings().withSize(960, 720));
    }

    @Test
    void whatNoFileCanHaveIsRefused() {
        assertThat(Components.isMarked(Components.enter(panel, "Pictures a second", "61")))
                .isTrue();
        assertThat(Components.isMarked(Components.enter(panel, "Width", "-5"))).isTrue();
        assertThat(Components.isMarked(Components.enter(panel, "Height", "100000")))
                .isTrue();
        assertThat(options.studio()).isEqualTo(studio);
        assertThat(options.frameRate()).isEqualTo(25);
    }
}
