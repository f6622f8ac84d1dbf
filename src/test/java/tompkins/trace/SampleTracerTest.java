package tompkins.trace;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
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

    /** A few of many scenes: rays without focus, pixels behind windows and filters, motion, and parts of the tree. */
    static Stream<Named<Studio>> studios() {
        Set<String> few = Set.of("figure 1b", "dust", "dust behind a window");
        Studio missed = StudioReader.read("""
                {
                  "velocity": [0, 0, 0.5],
                  "scene": [ { "type": "CylinderLattice" } ],
                  "camera": { "shutter": { "type": "FocusSurfaceShutter" }, "focus": { "type": "Sphere" } },
                  "cameraFrame": [
                    { "type": "Disc", "centre": [-1, 0, 5], "normal": [0, 0, 1],
                      "surface": { "type": "ColourFilter" } },
                    { "type": "Disc", "centre": [1, 0, 5], "normal": [0, 0, 1] }
                  ]
                }
                """, "scene", Path.of("."));
        Studio motion = StudioReader.read("""
                {
                  "scene": [
                    { "type": "Moving", "velocity": [0.6, 0, 0], "objects": [ { "type": "CylinderLattice" } ] },
                    { "type": "Sphere" }
                  ]
                }
                """, "scene", Path.of("."));
        return Stream.concat(
                VariedStudios.all().filter(studio -> few.contains(studio.getName())),
                Stream.of(Named.of("missed focus", missed), Named.of("motion", motion)));
    }

    @ParameterizedTest
    @MethodSource("studios")
    void blockHasTheColoursOfSingleSamples(Studio studio) {
        Studio small = studio.withSettings(studio.settings().withSize(60, 45));
        SampleTracer simple = RenderPlan.of(small).tracer(new RayCounts());
        RayCounts counts = new RayCounts();
        SampleTracer tracer = RenderPlan.of(small).tracer(counts);
        int[] taken = new int[1];
        for (int stride = 1; stride <= 3; stride += 2) {
            int side = stride * RayPacket.SIDE;
            int left = 60 - side - 1;
            // fewer rows than the block has room for
            int height = Math.min(side, 45 - 2);
            SampleSink taker = new StoppingTaker(Integer.MAX_VALUE) {
                @Override
                public void take(BlockSamples samples) {
                    taken[0] += samples.count();
                    assertThat(tracer.column()).isBetween(left, left + side - 1);
                    assertThat(tracer.row()).isBetween(1, height);
                    for (int i = 0; i < samples.count(); i++) {
                        assertThat(samples.colour(i)).isEqualTo(simple.sample(samples.column(i), samples.row(i), 1));
                    }
                }
            };
            tracer.beginBlock(left, 1, side, height, stride, taker);
            tracer.sampleBlock(1, taker);
        }

        assertThat(taken[0]).isEqualTo(16 * 16 + 16 * 15);
        assertThat(counts.samples).isEqualTo(taken[0]);
    }
}
