package tompkins.fuzz;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.fail;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import tompkins.TestRun;
import tompkins.camera.PixelSampler;
import tompkins.image.LinearImage;
import tompkins.ray.Colour;
import tompkins.ray.RayCounts;
import tompkins.render.Quality;
import tompkins.render.RenderJob;
import tompkins.render.RenderListener;
import tompkins.render.Renderer;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleTracer;

/**
 * Random studios render without an exception, without a colour that is no number, and soon. Long form: {@code mvn test
 * -Dtest=StudioFuzzTest -Dtompkins.fuzz=10000}; the first studio is that of {@code -Dtompkins.fuzz.seed}.
 */
class StudioFuzzTest {

    private static final int STUDIOS = Integer.getInteger("tompkins.fuzz", TestRun.cases(25, 300));
    private static final long FIRST = Long.getLong("tompkins.fuzz.seed", 1);
    private static final int PATIENCE_SECONDS = 60;

    @Test
    void randomStudiosRender() throws InterruptedException {
        try (Renderer renderer = new Renderer(2)) {
            for (long seed = FIRST; seed < FIRST + STUDIOS; seed++) {
                Studio studio = RandomStudio.of(seed);
                RenderJob job = render(renderer, studio, seed);
                for (float value : job.image().rgb()) {
                    if (!(value >= 0 && value < Float.POSITIVE_INFINITY)) {
                        fail("studio %d has a pixel of %f", seed, value);
                    }
                }
                assertThat(job.report().counts().notFinite)
                        .as("not finite in studio %d", seed)
                        .isZero();
            }
        }
    }

    private static RenderJob render(Renderer renderer, Studio studio, long seed) throws InterruptedException {
        CountDownLatch end = new CountDownLatch(1);
        RenderJob job = renderer.start(RenderPlan.of(studio), Quality.of(studio), new RenderListener() {
            @Override
            public void ended(RenderJob ended) {
                end.countDown();
            }
        });
        if (!end.await(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
            job.cancel();
            fail("studio %d takes longer than %d seconds", seed, PATIENCE_SECONDS);
        }
        if (job.failure() != null) {
            throw new AssertionError("studio " + seed, job.failure());
        }
        return job;
    }

    /**
     * Blocks of rays, trees and grids of lamps are short cuts; they must not change a picture. Over twice as many
     * powers of ten as a double has digits, rounding alone decides what is hit.
     */
    @Test
    void blocksGiveTheColoursOfSingleSamples() throws InterruptedException {
        try (Renderer renderer = new Renderer(2)) {
            for (long seed = FIRST; seed < FIRST + STUDIOS; seed++) {
                Studio random = RandomStudio.of(seed, 1.5 * (1 + seed % 4));
                Studio studio = random.withSettings(random.settings().withSamples(1));
                LinearImage picture = render(renderer, studio, seed).image();
                SampleTracer tracer = RenderPlan.of(studio).tracer(new RayCounts());
                float exposure = (float) Math.pow(2, studio.camera().exposureStops());
                for (int row = 0; row < picture.height(); row++) {
                    for (int column = 0; column < picture.width(); column++) {
                        Colour single = tracer.sample(column, row, PixelSampler.firstOf(1));
                        if (picture.value(column, row, 0) != (float) single.red() * exposure) {
                            fail("studio %d differs in pixel %d,%d", seed, column, row);
                        }
                    }
                }
            }
        }
    }
}
