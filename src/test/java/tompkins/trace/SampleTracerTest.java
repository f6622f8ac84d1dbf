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
        public boolean isStopped() {
            return rays++ >= raysBefore;
        }

        @Override
        public void take(BlockSamples samples) {
            taken += samples.count();
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
        SampleSink taker = new StoppingTaker(Integer.MAX_VALUE) {
            @Override
            public void take(BlockSamples samples) {
                for (int i = 0; i < samples.count(); i++) {
                    if (!samples.colour(i).equals(Colour.WHITE)) {
                        dark.add(samples.column(i) + ", " + samples.row(i) + ": " + samples.colour(i));
                    }
                }
            }
        };
        tracer.beginBlock(0, 0, 15, 15, 1, taker);
        tracer.sampleBlock(PixelSampler.firstOf(1), taker);

        assertThat(dark).containsExactly("7, 7: " + Colour.BLACK);
        assertThat(tracer.sample(7.5, 7.5, 0, 0, 0.5)).isEqualTo(Colour.BLACK);
        assertThat(counts.notFinite).isZero();
        assertThat(counts.samples).isEqualTo(15 * 15 + 1);
    }

    /** In this scene nothing moves with the camera: each ray is asked for once. */
    @Test
    void aBlockThatIsCutShortGivesItsFirstSamples() {
        RayCounts counts = new RayCounts();
        SampleTracer tracer = RenderPlan.of(PaperStudios.fig1a()).tracer(counts);
        SampleTracer simple = RenderPlan.of(PaperStudios.fig1a()).tracer(new RayCounts());
        StoppingTaker stopping = new StoppingTaker(7) {
            @Override
            public void take(BlockSamples samples) {
                super.take(samples);
                assertThat(samples.isWhole()).isFalse();
                for (int i = 0; i < samples.count(); i++) {
                    assertThat(samples.colour(i)).isEqualTo(simple.sample(samples.column(i), samples.row(i), 0));
                }
            }
        };
        tracer.beginBlock(0, 0, RayPacket.SIDE, RayPacket.SIDE, 1, stopping);
        tracer.sampleBlock(0, stopping);

        assertThat(stopping.taken).isEqualTo(7);
        assertThat(counts.samples).isEqualTo(stopping.taken);

        tracer.sampleBlock(0, new StoppingTaker(Integer.MAX_VALUE));
        assertThat(counts.samples).isEqualTo(stopping.taken + 16 * 16);
    }
}
