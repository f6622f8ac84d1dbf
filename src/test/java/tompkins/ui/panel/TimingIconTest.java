package tompkins.ui.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.stream.Stream;
import javax.swing.Icon;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import tompkins.shutter.SweepDirection;
import tompkins.ui.widget.Look;

class TimingIconTest {

    @BeforeAll
    static void look() {
        Look.LIGHT.install();
    }

    @Test
    void drawingsAreToldApart() {
        Stream<Icon> icons = Stream.concat(
                Stream.of(TimingIcon.exposure()),
                Stream.of(SweepDirection.values()).map(TimingIcon::rolling));
        assertThat(icons.map(TimingIconTest::pixels).distinct()).hasSize(5);
    }

    private static int pixels(Icon icon) {
        BufferedImage image = new BufferedImage(icon.getIconWidth(), icon.getIconHeight(), BufferedImage.TYPE_INT_ARGB);
        Graphics2D graphics = image.createGraphics();
        icon.paintIcon(null, graphics, 0, 0);
        graphics.dispose();
        return Arrays.hashCode(image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth()));
    }
}
