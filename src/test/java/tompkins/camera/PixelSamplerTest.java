package tompkins.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.ToIntFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.ray.RayPacket;

/** The places of samples: in their pixel and on the lens, evenly spread, the same again for the same seed. */
class PixelSamplerTest {

    private static final int SAMPLES = 256;

    @Test
    void placesLieInThePixelAndOnTheLens() {
        PixelSampler sampler = new PixelSampler(1, true, true);
        for (int sample = 0; sample < SAMPLES; sample++) {
            SamplePositions place = place(sampler, 17, 39, sample);
            assertThat(place.x[0]).isGreaterThanOrEqualTo(17).isLessThan(18);
            assertThat(place.y[0]).isGreaterThanOrEqualTo(39).isLessThan(40);
            assertThat(Math.hypot(place.lensX[0], place.lensY[0])).isLessThanOrEqualTo(1);
        }
    }

    @Test
    void centreIsTheCentre() {
        PixelSampler sampler = new PixelSampler(1, true, true);
        SamplePositions place = place(sampler, 17, 39, 5);
        sampler.choose(place, PixelSampler.firstOf(1));
        assertThat(place.x[0]).isEqualTo(17.5);
        assertThat(place.y[0]).isEqualTo(39.5);
        assertThat(place.lensX[0]).isZero();
        assertThat(place.lensY[0]).isZero();
        assertThat(PixelSampler.firstOf(2)).isZero();
    }

    /** Every power of two of samples has one in each interval, in each direction. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 16, 64, 256})
    void powersOfTwoFillEveryInterval(int count) {
        PixelSampler sampler = new PixelSampler(5, true, true);
        for (int column = 0; column < 4; column++) {
            int pixel = column;
            assertThat(intervals(sampler, pixel, count, each -> (int) ((each.x[0] - pixel) * count)))
                    .hasSize(count);
            assertThat(intervals(sampler, pixel, count, each -> (int) ((each.y[0] - 3) * count)))
                    .hasSize(count);
        }
    }

    private static Set<Integer> intervals(
            PixelSampler sampler, int column, int count, ToIntFunction<SamplePositions> interval) {
        Set<Integer> intervals = new HashSet<>();
        for (int sample = 0; sample < count; sample++) {
            intervals.add(interval.applyAsInt(place(sampler, column, 3, sample)));
        }
        return intervals;
    }

    /** The concentric map takes the square's sides to the circle and keeps the axes. */
    @Test
    void concentricMapKeepsCentreAxesAndRim() {
        double[][] places = {
            {0.5, 0.5, 0, 0},
            {1, 0.5, 1, 0},
            {0, 0.5, -1, 0},
            {0.5, 1, 0, 1},
            {0.5, 0, 0, -1},
            {0.75, 0.5, 0.5, 0},
            {1, 1, Math.sqrt(0.5), Math.sqrt(0.5)},
            {0, 1, -Math.sqrt(0.5), Math.sqrt(0.5)},
            {1, 0.75, Math.cos(Math.PI / 8), Math.sin(Math.PI / 8)},
            {0.75, 0, Math.sin(Math.PI / 8), -Math.cos(Math.PI / 8)}
        };
        for (double[] place : places) {
            double radius = ConcentricMap.radius(place[0], place[1]);
            double angle = ConcentricMap.angle(place[0], place[1]);
            assertThat(radius * Math.cos(angle)).isCloseTo(place[2], within(1e-15));
            assertThat(radius * Math.sin(angle)).isCloseTo(place[3], within(1e-15));
        }
    }

    @Test
    void pinholesHaveNoPlaceOnTheLens() {
        PixelSampler sampler = new PixelSampler(3, false, true);
        SamplePositions place = place(sampler, 1, 2, 3);
        assertThat(place.lensX[0]).isZero();
        assertThat(place.lensY[0]).isZero();
        assertThat(place.x[0]).isNotEqualTo(1.5);
    }

    @Test
    void placesDependOnSeedAndPixelAlone() {
        PixelSampler one = new PixelSampler(42, true, true);
        PixelSampler same = new PixelSampler(42, true, true);
        place(same, 100, 200, 77);
        SamplePositions ofOne = place(one, 8, 9, 10);
        SamplePositions ofSame = place(same, 8, 9, 10);
        assertThat(ofSame.x[0]).isEqualTo(ofOne.x[0]);
        assertThat(ofSame.lensY[0]).isEqualTo(ofOne.lensY[0]);
        Set<Double> firstPlaces = new HashSet<>();
        for (long seed : new long[] {1, 2, 3, -1, 1L << 32, 1L << 40}) {
            Set<Double> places = new HashSet<>();
            for (int pixel = 0; pixel < 64; pixel++) {
                PixelSampler sampler = new PixelSampler(seed, true, true);
                double x = place(sampler, pixel % 8, pixel / 8, 0).x[0];
                places.add(x - pixel % 8);
                if (pixel == 9) {
                    firstPlaces.add(x);
                }
            }
            assertThat(places).hasSize(64);
        }
        assertThat(firstPlaces).hasSize(6);
    }

    /** A block gives each pixel the places that it gets alone. */
    @Test
    void placesDoNotDependOnTheBlock() {
        PixelSampler sampler = new PixelSampler(7, true, true);
        SamplePositions block = new SamplePositions(RayPacket.MOST);
        for (int i = 0; i < RayPacket.MOST; i++) {
            block.addPixel(i % 17, i / 17);
        }
        sampler.choose(block, 12);
        Set<Double> different = new HashSet<>();
        for (int i = 0; i < RayPacket.MOST; i++) {
            SamplePositions single = place(sampler, i % 17, i / 17, 12);
            assertThat(block.x[i]).isEqualTo(single.x[0]);
            assertThat(block.y[i]).isEqualTo(single.y[0]);
            assertThat(block.lensX[i]).isEqualTo(single.lensX[0]);
            assertThat(block.lensY[i]).isEqualTo(single.lensY[0]);
            different.add(block.lensX[i]);
        }
        assertThat(different).hasSize(RayPacket.MOST);
    }

    /** What is kept from one sample of a block to the next is only what stays the same. */
    @Test
    void sampleIsWhereItWouldBeAlone() {
        for (boolean blurs : new boolean[] {false, true}) {
            PixelSampler kept = new PixelSampler(5, blurs, blurs);
            SamplePositions block = new SamplePositions(2);
            for (int column : new int[] {3, 4}) {
                block.clear();
                block.addPixel(column, 7);
                for (int sample : new int[] {0, 1, 255, 256, 1, 70_000, PixelSampler.CENTRE, 2}) {
                    kept.choose(block, sample);
                    SamplePositions alone = place(new PixelSampler(5, blurs, blurs), column, 7, sample);
                    assertThat(positions(block)).as("sample %d", sample).isEqualTo(positions(alone));
                }
            }
        }
    }

    private static List<Double> positions(SamplePositions of) {
        return List.of(of.x[0], of.y[0], of.lensX[0], of.lensY[0], of.moments[0]);
    }

    private static SamplePositions place(PixelSampler sampler, int column, int row, int sample) {
        SamplePositions place = new SamplePositions(1);
        place.addPixel(column, row);
        sampler.choose(place, sample);
        return place;
    }
}
