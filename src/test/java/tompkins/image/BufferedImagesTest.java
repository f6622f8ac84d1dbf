package tompkins.image;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class BufferedImagesTest {

    @ParameterizedTest
    @EnumSource
    void showsEachPixelInItsPlaceAndLevel(ToneCurve curve) {
        LinearImage image = Samples.random(7, 5, 1);

        BufferedImage shown = BufferedImages.toBufferedImage(image, curve);

        assertThat(shown.getType()).isEqualTo(BufferedImage.TYPE_INT_RGB);
        assertThat(shown.getWidth()).isEqualTo(7);
        assertThat(shown.getHeight()).isEqualTo(5);
        for (int y = 0; y < 5; y++) {
            for (int x = 0; x < 7; x++) {
                for (int channel = 0; channel < 3; channel++) {
                    assertThat(shown.getRGB(x, y) >> 16 - 8 * channel & 0xff)
                            .isEqualTo(curve.quantise(image.value(x, y, channel), 255));
                }
            }
        }
    }
}
