package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.List;
import org.junit.jupiter.api.Test;

class WindowIconTest {

    private final List<BufferedImage> images =
            WindowIcon.images().stream().map(BufferedImage.class::cast).toList();

    @Test
    void sizesAreThoseOfDesktops() {
        assertThat(images).extracting(BufferedImage::getWidth).containsExactly(16, 24, 32, 48, 64, 128);
        assertThat(images).allSatisfy(image -> assertThat(image.getHeight()).isEqualTo(image.getWidth()));
    }

    /** The waves of something that comes are blue, and close together. */
    @Test
    void lightIsBlueAheadAndRedBehind() {
        BufferedImage image = images.get(images.size() - 1);
        int middle = image.getHeight() / 2;
        Color behind = new Color(image.getRGB(image.getWidth() / 8, middle), true);
        Color ahead = new Color(image.getRGB(image.getWidth() * 7 / 8, middle), true);
        assertThat(behind.getRed()).isGreaterThan(2 * behind.getBlue());
        assertThat(ahead.getBlue()).isGreaterThan(2 * ahead.getRed());
        assertThat(image.getRGB(0, 0) >>> 24).as("nothing is in the corners").isZero();
    }
}
