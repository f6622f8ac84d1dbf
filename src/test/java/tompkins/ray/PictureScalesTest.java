package tompkins.ray;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Filtered pictures against sums over their pixels. */
class PictureScalesTest {

    private static final Random RANDOM = new Random(20261126);

    private static PixelPicture noise(int width, int height) {
        float[] rgba = new float[4 * width * height];
        for (int i = 0; i < rgba.length; i++) {
            rgba[i] = RANDOM.nextFloat();
        }
        return new PixelPicture("noise", width, height, rgba, new byte[0]);
    }

    /** Nothing is lost or counted twice on the way to a single pixel, whatever the sides are. */
    @ParameterizedTest
    @CsvSource({"1, 1", "2, 2", "3, 5", "7, 1", "64, 64", "101, 37"})
    void theWholePictureHasItsMean(int width, int height) {
        PixelPicture picture = noise(width, height);
        double light = 0;
        double opacity = 0;
        for (int pixel = 0; pixel < width * height; pixel++) {
            Texel texel = picture.pixel((pixel % width + 0.5) / width, 1 - (pixel / width + 0.5) / height);
            light += texel.light().green() / (width * height);
            opacity += texel.opacity() / (width * height);
        }

        Texel mean = picture.mean(0.3, 0.8, 3, 3, false);

        assertThat(mean.light().green()).isCloseTo(light, within(1e-6));
        assertThat(mean.opacity()).isCloseTo(opacity, within(1e-6));
    }

    /** From near a picture has no blocks: between the middles of two pixels light changes linearly. */
    @Test
    void lightBetweenPixelsIsLinear() {
        float[] rgba = {0, 0, 0, 1, 1, 0, 0, 1, 0, 4, 0, 1, 1, 4, 0, 1};
        PixelPicture picture = new PixelPicture("ramps", 2, 2, rgba, new byte[0]);
        for (double place = 0.25; place <= 0.75; place += 0.05) {
            Colour colour = picture.mean(place, 1 - place, 0, 0, false).light();
            assertThat(colour.red()).isCloseTo(2 * (place - 0.25), within(1e-12));
            assertThat(colour.green()).isCloseTo(8 * (place - 0.25), within(1e-12));
        }
        assertThat(picture.mean(0, 0.5, 0, 0, false).light().red()).isZero();
        assertThat(picture.mean(1, 0.5, 0, 0, false).light().red()).isEqualTo(1);
        assertThat(picture.mean(0, 0.5, 0, 0, true).light().red()).isEqualTo(0.5);
    }

    /** Colours that are hidden by transparency do not shine through at its edge. */
    @Test
    void whatIsTransparentAddsNoColour() {
        float[] rgba = {1, 1, 1, 0, 0.5f, 0.5f, 0.5f, 1};
        PixelPicture picture = new PixelPicture("edge", 2, 1, rgba, new byte[0]);
        Texel middle = picture.mean(0.5, 0.5, 0, 0, false);
        assertThat(middle.opacity()).isCloseTo(0.5, within(1e-12));
        assertThat(middle.light().red()).isCloseTo(0.25, within(1e-12));
        assertThat(picture.mean(0.5, 0.5, 1, 1, false).light().red()).isCloseTo(0.25, within(1e-7));
    }

    /** Spots of all shapes against the mean of their pixels: the rest is the softness of their edges. */
    @ParameterizedTest
    @CsvSource({"16, 16", "4, 64", "64, 4", "2, 100", "1, 1"})
    void aSpotShowsItsMean(int across, int down) {
        int size = 256;
        float[] rgba = new float[4 * size * size];
        for (int i = 0; i < size * size; i++) {
            double wave = Math.sin(0.05 * (i % size)) + Math.cos(0.03 * (i / size));
            rgba[4 * i] = (float) (2 + wave + RANDOM.nextDouble());
            rgba[4 * i + 3] = 1;
        }
        PixelPicture picture = new PixelPicture("waves", size, size, rgba, new byte[0]);
        double sum = 0;
        int trials = 40;
        for (int trial = 0; trial < trials; trial++) {
            int left = 100 + RANDOM.nextInt(40);
            int top = 60 + RANDOM.nextInt(70);
            double mean = 0;
            for (int y = top; y < top + down; y++) {
                for (int x = left; x < left + across; x++) {
                    mean += rgba[4 * (y * size + x)] / (across * down);
                }
            }
            double u = (left + across / 2.0) / size;
            double v = 1 - (top + down / 2.0) / size;
            double found = picture.mean(u, v, across / 2.0 / size, down / 2.0 / size, false)
                    .light()
                    .red();
            sum += Math.abs(found - mean) / trials;
        }
        // one pixel alone differs by 0.25 on the mean
        assertThat(sum).isLessThan(across * down == 1 ? 1e-6 : 0.06);
    }
}
