package tompkins.ui.photograph;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Rectangle;
import java.util.Arrays;
import java.util.List;
import javax.swing.JButton;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.camera.FieldOfView;
import tompkins.image.LinearImage;
import tompkins.light.ColourLaw;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.spacetime.Velocity;
import tompkins.studio.FrontWindow;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.studio.UniformBackground;
import tompkins.surface.LorentzWindow;
import tompkins.ui.Components;
import tompkins.ui.LightLook;
import tompkins.ui.SilentListener;
import tompkins.ui.WindowDriver;
import tompkins.ui.model.StudioModel;
import tompkins.ui.picture.Picture;

/** What is offered on a picture that is spoilt, without a display. */
@LightLook
@Timeout(120)
class PictureNoticeTest {

    private final StudioModel model = new StudioModel(Studios.sphere(), null);

    @AutoClose
    private final PhotographView view =
            WindowDriver.onEventThread(() -> new PhotographView(model, new SilentListener()));

    @ParameterizedTest
    @CsvSource({"5, 3", "4, 2", "4.0001, 3", "1.5, 1", "1, 0", "Infinity, 128"})
    void theExposureGoesDownUntilHardlyAPixelIsWhite(float brightest, int stops) {
        float[] rgb = new float[3 * 100];
        Arrays.fill(rgb, 0.5f);
        for (int pixel = 0; pixel < 60; pixel++) {
            rgb[3 * pixel + pixel % 3] = brightest;
        }
        // a few may stay white
        for (int pixel = 60; pixel < 70; pixel++) {
            rgb[3 * pixel] = 1e9f;
        }
        assertThat(PictureNotice.stopsTooMany(new LinearImage(10, 10, rgb))).isEqualTo(stops);
    }

    private Picture complete(Studio studio) {
        WindowDriver.onEventThread(() -> {
            view.canvas().setSize(64, 48);
            model.set(studio);
        });
        return awaitPicture();
    }

    private Picture awaitPicture() {
        WindowDriver.await("the complete picture", () -> {
            Picture now = view.canvas().shown().now();
            return now != null && now.complete() && now.studio().equals(model.studio());
        });
        return view.canvas().shown().now();
    }

    private JButton button() {
        return Components.find(view.canvas(), JButton.class, "notice.remedy");
    }

    @Test
    void aBurntPictureOffersALowerExposure() {
        Studio bright = Descriptions.with(
                Studios.sphere().withScene(List.of()), "background", new UniformBackground(Colour.grey(0.9)));
        assertThat(complete(bright).flaw()).isEqualTo(Picture.Flaw.NONE);
        assertThat(button().getParent().isVisible()).isFalse();
        // behind a moving camera the middle is darkest, and keeps its brightness
        Studio burnt = bright.withVelocity(Velocity.of(0, 0, -0.999))
                .withCamera(FieldOfView.with(bright.camera(), 150))
                .withColours(ColourLaw.SEARCHLIGHT);
        assertThat(complete(burnt).flaw()).isEqualTo(Picture.Flaw.BURNT);
        WindowDriver.await("the offer", () -> button().getParent().isVisible());
        WindowDriver.onEventThread(() -> {
            view.canvas().setSize(260, 195);
            Components.layOut(view.canvas());
            Rectangle notice = button().getParent().getBounds();
            assertThat(new Rectangle(260, 195).contains(notice))
                    .as("%s", notice)
                    .isTrue();
            assertThat(new Rectangle(notice.getSize()).contains(button().getBounds()))
                    .isTrue();
        });
        WindowDriver.onEventThread(() -> button().doClick());
        assertThat(model.studio().camera().exposureStops()).isLessThan(0);
        assertThat(awaitPicture().flaw()).isEqualTo(Picture.Flaw.NONE);
        assertThat(button().getParent().isVisible()).isFalse();
        WindowDriver.onEventThread(model::undo);
        assertThat(model.studio()).isEqualTo(burnt);
    }

    @Test
    void aWindowThroughWhichNothingIsSeenCanBeRemoved() {
        Studio seen = Studios.sphere();
        Velocity away = Velocity.of(0.999, 0, 0);
        Studio empty = FrontWindow.with(seen, LorentzWindow.DEFAULT.withVelocity(away));
        assertThat(complete(empty).flaw()).isEqualTo(Picture.Flaw.EMPTY);
        WindowDriver.await("the offer", () -> button().getParent().isVisible());
        WindowDriver.onEventThread(() -> button().doClick());
        assertThat(model.studio()).isEqualTo(seen);
        assertThat(awaitPicture().flaw()).isEqualTo(Picture.Flaw.NONE);
    }
}
