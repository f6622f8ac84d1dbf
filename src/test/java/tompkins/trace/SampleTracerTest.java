package tompkins.trace;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import tompkins.ray.Colour;
import tompkins.ray.RayBlock;
import tompkins.ray.RayCounts;
import tompkins.studio.PaperStudios;

class SampleTracerTest {

    /** Somebody who wants every pixel, but stops before a ray. */
    private static final class StoppingTaker implements SampleTaker {

        private final int raysBefore;
        private int rays;
        private int taken;

        StoppingTaker(int raysBefore) {
            this.raysBefore = raysBefore;
        }

        @Override
        public boolean wants(int column, int row) {
            return true;
        }

        @Override
        public boolean isStopped() {
            return rays++ >= raysBefore;
        }

        @Override
        public void take(int column, int row, Colour colour) {
            taken++;
        }
    }

    /** In this scene nothing moves with the camera: each ray is asked for once. */
    @Test
    void samplesThatAStopLeftOutAreNotCounted() {
        RayCounts counts = new RayCounts();
        SampleTracer tracer = RenderPlan.of(PaperStudios.fig1a()).tracer(counts);
        StoppingTaker stopping = new StoppingTaker(7);
        tracer.sampleBlock(0, 0, RayBlock.SIDE, RayBlock.SIDE, 1, 0, stopping);

        assertThat(stopping.taken).isEqualTo(7);
        assertThat(counts.samples).isEqualTo(7);

        tracer.sampleBlock(0, 0, RayBlock.SIDE, RayBlock.SIDE, 1, 0, new StoppingTaker(Integer.MAX_VALUE));
        assertThat(counts.samples).isEqualTo(7 + 16 * 16);
    }
}
