package tompkins.ui.panel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.stream.Stream;
import javax.swing.Icon;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.property.Descriptions;
import tompkins.shutter.Shutter;

class ShutterIconTest {

    static Stream<Class<?>> shutters() {
        return Descriptions.members(Shutter.class).stream();
    }

    /** Without one the window does not open at all. */
    @ParameterizedTest
    @MethodSource("shutters")
    void everyShutterHasADrawing(Class<?> shutter) {
        assertThatCode(() -> ShutterIcon.of(shutter, Color.BLACK))
                .as("add a drawing of %s to ShutterIcon.DRAWINGS", shutter.getSimpleName())
                .doesNotThrowAnyException();
    }

    @Test
    void shuttersAreToldApart() {
        Map<Integer, Class<?>> seen = new HashMap<>();
        shutters().forEach(shutter -> {
            Class<?> other = seen.put(pixels(shutter), shutter);
            assertThat(other).as("drawn just as %s", shutter.getSimpleName()).isNull();
        });
    }

    private static int pixels(Class<?> shutter) {
        Icon icon = ShutterIcon.of(shutter, Color.BLACK);
        BufferedImage image = new BufferedImage(icon.getIconWidth(), icon.getIconHeight(), BufferedImage.TYPE_INT_ARGB);
        Graphics2D graphics = image.createGraphics();
        icon.paintIcon(null, graphics, 0, 0);
        graphics.dispose();
        return Arrays.hashCode(image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth()));
    }
}
