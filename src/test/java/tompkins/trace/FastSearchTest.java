package tompkins.trace;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.Arrays;
import java.util.stream.Stream;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.TestRun;
import tompkins.camera.EyeView;
import tompkins.camera.SamplePositions;
import tompkins.io.BundledScenes;
import tompkins.primitive.Primitive;
import tompkins.ray.Colour;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.ray.RayPacket;
import tompkins.spacetime.Event;
import tompkins.studio.Studio;
import tompkins.world.InertialFrame;

/**
 * Everything that makes the search fast (trees, candidates of a block of rays, grids of lamps) leaves every colour as
 * it is, to the last bit: compared with one sample after the other, whose first hits are compared with those of a
 * search through all primitives.
 */
class FastSearchTest {

    /** No multiple of the side of a block of rays, nor of half of it. */
    private static final int WIDTH = TestRun.cases(27, 77);

    @ParameterizedTest
    @MethodSource("studios")
    void everyWayOfSearchingGivesTheSameColours(Studio studio) {
        RenderPlan plan = RenderPlan.of(studio);
        Picture oneByOne = new Picture(studio);
        Picture blocks = new Picture(studio);
        Picture coarseBlocks = new Picture(studio);

        oneByOne.takeOneByOne(plan);
        blocks.takeBlocks(plan, 1);
        for (int stride = 8; stride >= 1; stride /= 2) {
            coarseBlocks.takeBlocks(plan, stride);
        }

        blocks.mustEqual(oneByOne);
        coarseBlocks.mustEqual(oneByOne);
    }

    /** Where everything rests in one frame, each primitive is asked by itself. */
    @ParameterizedTest
    @MethodSource("studios")
    void theNearestOfAllPrimitivesIsHit(Studio studio) {
        RenderPlan plan = RenderPlan.of(studio);
        InertialFrame frame = plan.world().frames().get(0);
        SamplePositions.spread(plan.width(), plan.height(), 8).forEach(place -> {
            SampleHistory history = SampleHistory.of(plan, place.x(), place.y(), 0, 0);
            if (plan.world().moves() || history == null || history.sceneStart() == null) {
                return;
            }
            Event start = history.sceneStart().minus(frame.origin());
            Vector3dc way = history.sceneDirection();
            Ray ray = Ray.from(start.x(), start.y(), start.z(), way.x(), way.y(), way.z(), start.time());
            double nearest = frame.objects().primitives().stream()
                    .mapToDouble(primitive -> primitive.distance(ray, Primitive.NO_HIT))
                    .min()
                    .orElse(Primitive.NO_HIT);
            double found = history.mainHits().stream()
                    .filter(hit -> hit.frame() == Frame.SCENE)
                    .findFirst()
                    .map(SampleHistory.Encounter::distance)
                    .orElse(Primitive.NO_HIT);
            assertThat(found).isCloseTo(nearest, withinPercentage(1e-6));
        });
    }

    static Stream<Named<Studio>> studios() {
        Stream<Named<Studio>> scenes =
                BundledScenes.named().entrySet().stream().map(scene -> Named.of(scene.getKey(), scene.getValue()));
        return Stream.concat(VariedStudios.all(), scenes)
                .map(named -> Named.of(named.getName(), small(named.getPayload())));
    }

    private static Studio small(Studio studio) {
        int samples = Math.min(2, studio.settings().samples());
        return studio.withSettings(
                studio.settings().withSize(WIDTH, WIDTH * 3 / 4 + 1).withSamples(samples));
    }

    /** The colours of all samples, and what was counted on the way. */
    private static final class Picture {

        private final int width;
        private final int height;
        private final int samples;
        private final Colour[] colours;
        private final RayCounts counts = new RayCounts();

        Picture(Studio studio) {
            width = studio.settings().width();
            height = studio.settings().height();
            samples = studio.settings().samples();
            colours = new Colour[width * height * samples];
        }

        void takeOneByOne(RenderPlan plan) {
            SampleTracer tracer = plan.tracer(counts);
            for (int i = 0; i < colours.length; i++) {
                int pixel = i / samples;
                colours[i] = tracer.sample(pixel % width, pixel / width, i % samples);
            }
        }

        /** Takes what has not been taken yet of every pixel whose coordinates are multiples of the stride. */
        void takeBlocks(RenderPlan plan, int stride) {
            SampleTracer tracer = plan.tracer(counts);
            SamplePositions pixels = new SamplePositions(RayPacket.MOST);
            int side = RayPacket.SIDE * stride;
            for (int top = 0; top < height; top += side) {
                for (int left = 0; left < width; left += side) {
                    for (EyeView eye : plan.pictureRays().views()) {
                        pixels.begin(eye);
                        pixels.addPixels(
                                left,
                                top,
                                Math.min(side, width - left),
                                Math.min(side, height - top),
                                stride,
                                (x, y) -> plan.pictureRays().view(x, y) == eye && colours[index(x, y, 0)] == null);
                        for (int sample = 0; sample < samples; sample++) {
                            BlockSamples taken = tracer.sampleBlock(pixels, sample, () -> false);
                            for (int i = 0; i < pixels.count(); i++) {
                                colours[index(pixels.column(i), pixels.row(i), sample)] = taken.colour(i);
                            }
                        }
                    }
                }
            }
        }

        private int index(int column, int row, int sample) {
            return (row * width + column) * samples + sample;
        }

        void mustEqual(Picture other) {
            // records of doubles are equal if their bits are
            assertThat(colours).isEqualTo(other.colours);
            assertThat(Arrays.stream(colours).distinct())
                    .as("different colours")
                    .hasSizeGreaterThan(2);
            // less work is what it is all for
            assertThat(counts)
                    .usingRecursiveComparison()
                    .ignoringFields("nodes", "tests")
                    .isEqualTo(other.counts);
        }
    }
}
