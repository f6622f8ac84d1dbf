package tompkins.ui.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dimension;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;
import tompkins.image.LinearImage;
import tompkins.render.Renderer;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.trace.RenderPlan;

class ScreenPicturesTest {

    private final BlockingQueue<Object> events = new LinkedBlockingQueue<>();

    private Object nextEvent() throws InterruptedException {
        return events.poll(5, TimeUnit.MINUTES);
    }

    private static Picture picture(RenderPlan plan, LinearImage image) {
        return Pictures.of(plan.studio(), plan, image, Double.NaN);
    }

    private static Picture grey(int width, int height) {
        float[] rgb = new float[3 * width * height];
        Arrays.fill(rgb, 0.5f);
        Studio studio = Studios.sphere();
        return picture(
                RenderPlan.of(studio.withSettings(studio.settings().withSize(width, height))),
                new LinearImage(width, height, rgb));
    }

    /** Stretched to the place of another picture, it would show another scene. */
    @Test
    void aPictureOfOtherProportionsIsNotCompared() throws InterruptedException {
        try (ScreenPictures screen = new ScreenPictures(events::add, events::add)) {
            screen.setRoom(new Room(new Dimension(100, 100), false, false));
            screen.setNow(grey(64, 48));
            screen.setOther(grey(32, 24));
            ScreenPicture shown = await(picture -> picture.other() != null);
            assertThat(shown.otherImage()).isNotNull();
            screen.setNow(grey(64, 32));
            shown = await(picture -> picture.now().image().height() == 32);
            assertThat(shown.other()).isNotNull();
            assertThat(shown.otherImage()).isNull();
            screen.setNow(grey(64, 48));
            shown = await(picture -> picture.now().image().height() == 48);
            assertThat(shown.otherImage()).isNotNull();
        }
    }

    /** It would be made for a size that is no size, and be shown as one pixel. */
    @Test
    void noPictureIsShownBeforeItsSizeIsKnown() throws InterruptedException {
        try (ScreenPictures screen = new ScreenPictures(events::add, events::add)) {
            screen.setNow(grey(64, 48));
            screen.setRoom(new Room(new Dimension(32, 100), false, false));
            ScreenPicture shown = (ScreenPicture) nextEvent();
            assertThat(shown.nowImage().getWidth()).isEqualTo(32);
            assertThat(events).isEmpty();
        }
    }

    /** A picture that was kept before the window became larger has other pixels, rounded in another way. */
    @Test
    void photographsDecideWhatCanBeCompared() throws InterruptedException {
        Studio studio = Studios.sphere();
        Studio large = studio.withSettings(studio.settings().withSize(1920, 1080));
        try (ScreenPictures screen = new ScreenPictures(events::add, events::add)) {
            screen.setRoom(new Room(new Dimension(997, 700), false, false));
            screen.setNow(Pictures.black(large, 997, 561));
            screen.setOther(Pictures.black(large, 501, 282));
            ScreenPicture shown = await(picture -> picture.other() != null);
            assertThat(shown.nowImage().getHeight()).isEqualTo(561);
            assertThat(shown.otherImage()).isNotNull();
        }
    }

    /** One bright column in eight: between the columns that a single step looks at, it would be lost. */
    @Test
    void aLargePictureIsReducedWithAllItsPixels() {
        BufferedImage stripes = new BufferedImage(128, 64, BufferedImage.TYPE_INT_RGB);
        for (int row = 0; row < 64; row++) {
            for (int column = 0; column < 128; column += 8) {
                stripes.setRGB(column, row, 0xf0f0f0);
            }
        }
        BufferedImage reduced = ScreenPicture.scaled(stripes, new Dimension(16, 8));
        for (int column = 0; column < 16; column++) {
            assertThat(reduced.getRGB(column, 4) & 0xff).isEqualTo(0xf0 / 8);
        }
    }

    private ScreenPicture await(Predicate<ScreenPicture> condition) throws InterruptedException {
        ScreenPicture shown = (ScreenPicture) nextEvent();
        while (!condition.test(shown)) {
            shown = (ScreenPicture) nextEvent();
        }
        return shown;
    }

    @Test
    void theNextPictureFollowsAFailedPreparation() throws InterruptedException {
        RenderPlan plan = RenderPlan.of(Studios.sphere());
        try (Renderer renderer = new Renderer(1);
                ScreenPictures screen = new ScreenPictures(events::add, events::add)) {
            screen.setRoom(new Room(new Dimension(100, 100), false, false));
            screen.setNow(picture(plan, null));
            assertThat(nextEvent()).isInstanceOf(NullPointerException.class);
            Picture good = picture(plan, renderer.render(plan).image());
            screen.setNow(good);
            assertThat(nextEvent())
                    .isInstanceOf(ScreenPicture.class)
                    .extracting("now")
                    .isSameAs(good);
        }
    }
}
