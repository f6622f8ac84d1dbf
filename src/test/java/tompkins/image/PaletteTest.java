package tompkins.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.util.function.IntBinaryOperator;
import org.junit.jupiter.api.Test;

class PaletteTest {

    private static final int SIDE = 256;

    private static BufferedImage picture(IntBinaryOperator colours) {
        BufferedImage picture = new BufferedImage(SIDE, SIDE, BufferedImage.TYPE_INT_RGB);
        for (int row = 0; row < SIDE; row++) {
            for (int column = 0; column < SIDE; column++) {
                picture.setRGB(column, row, colours.applyAsInt(column, row));
            }
        }
        return picture;
    }

    private static int colours(BufferedImage picture) {
        return ((IndexColorModel) picture.getColorModel()).getMapSize();
    }

    @Test
    void aPictureWithFewColoursKeepsThem() {
        // 32 by 8 colours, far apart and near each other
        BufferedImage picture = picture((column, row) -> 0x070000 * (column / 8) + 0xFE0101 * (row / 32) & 0xFFFFFF);
        BufferedImage few = Palette.reduced(picture);
        assertThat(colours(few)).isEqualTo(256);
        for (int shift = 0; shift < 24; shift += 8) {
            assertThat(PictureDifference.ofLevels(picture, few, shift)).isZero();
        }
    }

    @Test
    void onePlainColourStaysAlone() {
        BufferedImage few = Palette.reduced(picture((column, row) -> 0x123456));
        assertThat(colours(few)).isEqualTo(1);
        assertThat(few.getRGB(3, 5)).isEqualTo(0xFF123456);
    }

    /**
     * Red grows to the right and blue downwards: the best 256 colours are 16 by 16, each for 16 by 16 levels, which
     * differ from their mean, a half, by that of the numbers 0.5, 1.5 to 7.5; rounding the mean adds a quarter.
     */
    @Test
    void twoRampsAreDividedAsFinelyAsCanBe() {
        BufferedImage picture = picture((column, row) -> column << 16 | row);
        BufferedImage few = Palette.reduced(picture);
        assertThat(colours(few)).isEqualTo(256);
        double best = Math.sqrt((16 * 16 - 1) / 12.0 + 0.25);
        assertThat(PictureDifference.ofLevels(picture, few, 16)).isCloseTo(best, within(1e-9));
        assertThat(PictureDifference.ofLevels(picture, few, 0)).isCloseTo(best, within(1e-9));
        assertThat(PictureDifference.ofLevels(picture, few, 8)).isZero();
    }
}
