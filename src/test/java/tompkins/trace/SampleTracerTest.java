package tompkins.trace;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import tompkins.camera.PixelSampler;
import tompkins.camera.SamplePositions;
import tompkins.io.StudioReader;
import tompkins.ray.Colour;
import tompkins.ray.RayCounts;
import tompkins.ray.RayPacket;
import tompkins.studio.PaperStudios;
import tompkins.studio.Studio;

class SampleTracerTest {

    private static SamplePositions pixels(RenderPlan plan, int side) {
        SamplePositions pixels = new SamplePositions(RayPacket.MOST);
        pixels.begin(plan.pictureRays().views().get(0));
        pixels.addPixels(0, 0, side, side, 1, (column, row) -> true);
        return pixels;
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
        RenderPlan plan = RenderPlan.of(studio);
        SampleTracer tracer = plan.tracer(counts);
        SamplePositions pixels = pixels(plan, 15);
        BlockSamples samples = tracer.sampleBlock(pixels, PixelSampler.CENTRE, () -> false);
        for (int i = 0; i < pixels.count(); i++) {
            if (!samples.colour(i).equals(Colour.WHITE)) {
                dark.add(pixels.column(i) + ", " + pixels.row(i) + ": " + samples.colour(i));
            }
        }

        assertThat(dark).containsExactly("7, 7: " + Colour.BLACK);
        assertThat(tracer.sample(7.5, 7.5, 0, 0, 0.5)).isEqualTo(Colour.BLACK);
        assertThat(counts.notFinite).isZero();
        assertThat(counts.samples).isEqualTo(15 * 15 + 1);
    }

    /** In this scene nothing moves with the camera: each ray is asked for once. */
    @Test
    void aBlockThatIsStoppedHasNoSamples() {
        RayCounts counts = new RayCounts();
        RenderPlan plan = RenderPlan.of(PaperStudios.fig1a());
        SampleTracer tracer = plan.tracer(counts);
        SamplePositions pixels = pixels(plan, RayPacket.SIDE);
        AtomicInteger asked = new AtomicInteger();

        assertThat(tracer.sampleBlock(pixels, 0, () -> asked.incrementAndGet() > 7))
                .isNull();
        assertThat(counts.samples).isZero();
        assertThat(counts.rays).isGreaterThanOrEqualTo(7).isLessThan(16 * 16);

        assertThat(tracer.sampleBlock(pixels, 0, () -> false)).isNotNull();
        assertThat(counts.samples).isEqualTo(16 * 16);
    }
}
