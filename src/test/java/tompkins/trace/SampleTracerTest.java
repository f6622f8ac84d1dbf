package tompkins.trace;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import tompkins.camera.PixelSampler;
import tompkins.io.StudioReader;
import tompkins.ray.Colour;
import tompkins.ray.RayCounts;
import tompkins.ray.RayPacket;
import tompkins.studio.PaperStudios;
import tompkins.studio.Studio;

class SampleTracerTest {

    /** Somebody who wants every pixel, but stops before a ray. */
    private static class StoppingTaker implements SampleSink {

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

    /** Straight ahead, light of half the speed stands still for a camera that moves as fast. */
    @Test
    void lightAtRestInTheSceneIsBlackAndAlone() {
        Studio studio = StudioReader.read("""
                {
                  "velocity": [0, 0, 0.5], "transformation": "galilean",
                  "background": { "type": "UniformBackground", "colour": 1 },
                  "settings": { "width": 15, "height": 15 },
                  "cameraFrame": [
                    { "type": "Plane", "point": [0, 0, -1], "normal": [0, 0, -1],
                      "surface": { "type": "Refractive", "indexRatio": 2 } }
                  ]
                }
                """, "scene", Path.of("."));
        RayCounts counts = new RayCounts();
        List<String> dark = new ArrayList<>();
        SampleTracer tracer = RenderPlan.of(studio).tracer(counts);
        tracer.sampleBlock(0, 0, 15, 15, 1, PixelSampler.firstOf(1), new StoppingTaker(Integer.MAX_VALUE) {
            @Override
            public void take(int column, int row, Colour colour) {
                if (!colour.equals(Colour.WHITE)) {
                    dark.add(column + ", " + row + ": " + colour);
                }
            }
        });

        assertThat(dark).containsExactly("7, 7: " + Colour.BLACK);
        assertThat(tracer.sample(7.5, 7.5, 0, 0, 0.5)).isEqualTo(Colour.BLACK);
        assertThat(counts.notFinite).isZero();
        assertThat(counts.samples).isEqualTo(15 * 15 + 1);
    }

    /** In this scene nothing moves with the camera: each ray is asked for once. */
    @Test
    void samplesThatAStopLeftOutAreNotCounted() {
        RayCounts counts = new RayCounts();
        SampleTracer tracer = RenderPlan.of(PaperStudios.fig1a()).tracer(counts);
        StoppingTaker stopping = new StoppingTaker(7);
        tracer.sampleBlock(0, 0, RayPacket.SIDE, RayPacket.SIDE, 1, 0, stopping);

        assertThat(stopping.taken).isEqualTo(7);
        assertThat(counts.samples).isEqualTo(7);

        tracer.sampleBlock(0, 0, RayPacket.SIDE, RayPacket.SIDE, 1, 0, new StoppingTaker(Integer.MAX_VALUE));
        assertThat(counts.samples).isEqualTo(7 + 16 * 16);
    }
}
