package tompkins.ray;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Where the pixels of a picture lie, and which of them are dark. */
class PixelPictureTest {

    /** Three columns, two rows; red tells the pixel: 1, 2, 3 above, 4, 5, 6 below. */
    private static PixelPicture six() {
        float[] rgba = new float[24];
        for (int pixel = 0; pixel < 6; pixel++) {
            rgba[4 * pixel] = pixel + 1;
            rgba[4 * pixel + 1] = 10 * (pixel + 1);
            rgba[4 * pixel + 2] = 100 * (pixel + 1);
            rgba[4 * pixel + 3] = 1;
        }
        return new PixelPicture("six", 3, 2, rgba, new byte[0]);
    }

    @ParameterizedTest
    @CsvSource({
        // the middles
        "0.17, 0.75, 1",
        "0.5, 0.75, 2",
        "0.83, 0.75, 3",
        "0.17, 0.25, 4",
        "0.5, 0.25, 5",
        "0.83, 0.25, 6",
        // next to the borders between pixels
        "0.333, 0.501, 1",
        "0.334, 0.501, 2",
        "0.666, 0.499, 5",
        "0.667, 0.499, 6",
        // the corners, and what rounding puts beyond them
        "0, 1, 1",
        "1, 1, 3",
        "0, 0, 4",
        "1, 0, 6",
        "-1e-12, 1.000001, 1",
        "1.000001, -1e-12, 6",
        "1e300, 0.4, 6",
        "0.5, -1e300, 5"
    })
    void colourIsThatOfThePixel(double u, double v, int pixel) {
        assertThat(six().colour(u, v)).isEqualTo(new Colour(pixel, 10 * pixel, 100 * pixel));
    }

    /** Opacity and channels as levels of 255; the luminance is 0.2126 red + 0.7152 green + 0.0722 blue. */
    @ParameterizedTest
    @CsvSource({
        "255, 0, 0, 0, true",
        "255, 126, 126, 126, true",
        "255, 127, 127, 127, false",
        "128, 126, 126, 126, true",
        "127, 0, 0, 0, false",
        "0, 0, 0, 0, false",
        "255, 255, 255, 0, false",
        "255, 0, 255, 255, false",
        "255, 0, 255, 0, false",
        "255, 255, 0, 0, true",
        "255, 0, 0, 255, true",
        "255, 255, 0, 255, true",
        "255, 0, 0, 128, true",
        "255, 0, 178, 0, false",
        "255, 0, 177, 0, true"
    })
    void isDarkWhereOpaqueWithLittleLuminance(int opacity, int red, int green, int blue, boolean dark) {
        float[] rgba = {red / 255f, green / 255f, blue / 255f, opacity / 255f};
        assertThat(new PixelPicture("one", 1, 1, rgba, new byte[0]).isDark(0.5, 0.5))
                .isEqualTo(dark);
    }

    @Test
    void halfOpaqueCountsAsOpaque() {
        assertThat(new PixelPicture("one", 1, 1, new float[] {0, 0, 0, 0.5f}, new byte[0]).isDark(0.5, 0.5))
                .isTrue();
    }

    @ParameterizedTest
    @CsvSource({"0, 1, 0", "1, 0, 0", "2, 1, 4", "1, 1, 8"})
    void valuesMustFillThePicture(int width, int height, int values) {
        float[] rgba = new float[values];
        assertThatThrownBy(() -> new PixelPicture("odd", width, height, rgba, new byte[0]))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith("odd: ");
    }
}
