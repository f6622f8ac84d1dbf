package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import tompkins.image.LinearImage;
import tompkins.render.Quality;
import tompkins.render.Renderer;
import tompkins.trace.RenderPlan;

class ScreenPicturesTest {

    private final BlockingQueue<Object> events = new LinkedBlockingQueue<>();

    private Object nextEvent() throws InterruptedException {
        return events.poll(10, TimeUnit.SECONDS);
    }

    private static Picture picture(RenderPlan plan, LinearImage image) {
        return new Picture(plan, Quality.of(plan), image, true, Duration.ZERO, 1, Double.NaN, List.of());
    }

    @Test
    void aPictureThatCannotBePreparedIsToldAndTheNextOneIsShown() throws InterruptedException {
        RenderPlan plan = RenderPlan.of(Studios.sphere());
        try (Renderer renderer = new Renderer(1);
                ScreenPictures screen = new ScreenPictures(events::add, events::add)) {
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
