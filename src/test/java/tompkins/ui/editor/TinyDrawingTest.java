package tompkins.ui.editor;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.Icon;
import javax.swing.JLabel;
import javax.swing.UIManager;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.property.Descriptions;
import tompkins.sceneobject.SceneObject;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.shutter.Shutter;
import tompkins.studio.UniformBackground;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Surface;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.TinyDrawing;

class TinyDrawingTest {

    static Stream<Class<?>> types(Class<?> family) {
        return Hiding.types(family).stream();
    }

    static Stream<Class<?>> objectsAndSurfaces() {
        return Stream.of(SceneObject.class, Surface.class).flatMap(TinyDrawingTest::types);
    }

    @ParameterizedTest
    @MethodSource("objectsAndSurfaces")
    void objectsAndSurfacesHaveDrawings(Class<?> type) {
        assertThat(TinyDrawing.of(type))
                .as("add a drawing of %s to TinyDrawings.properties", type.getSimpleName())
                .isNotNull();
        int[] pixels = pixels(type);
        assertThat(Arrays.stream(pixels).filter(pixel -> pixel != 0).count()).isGreaterThan(20);
        // nothing is cut off
        assertThat(IntStream.range(0, 30).allMatch(i -> pixels[i] == 0 && pixels[21 * 30 + i] == 0))
                .isTrue();
    }

    @Test
    void typesAreToldApart() {
        for (Class<?> family : new Class<?>[] {SceneObject.class, Surface.class}) {
            Map<Integer, Class<?>> seen = new HashMap<>();
            types(family).forEach(type -> {
                Class<?> other = seen.put(Arrays.hashCode(pixels(type)), type);
                assertThat(other).as("drawn just as %s", type.getSimpleName()).isNull();
            });
        }
    }

    @Test
    void drawingsHaveTheColourOfTheText() {
        assertThat(Arrays.stream(pixels(ColouredSurface.class))).contains(Color.MAGENTA.getRGB());
        assertThat(TinyDrawing.of(UniformBackground.class)).isNull();
    }

    /** Without one the window does not open at all. */
    @Test
    void shuttersAreDrawnAndToldApart() {
        assertThat(Descriptions.members(Shutter.class).stream()
                        .map(type -> Arrays.stream(pixels(type)).boxed().toList()))
                .hasSize(6)
                .doesNotHaveDuplicates();
    }

    @Test
    void wordsBeforeAStrokeSayHowItIsDrawn() {
        Look.LIGHT.install();
        Color accent = UIManager.getColor("Component.accentColor");
        int[] pixels = pixels(AperturePlaneShutter.class);
        // the shutter is a line at x = 24 of 64, here 15 of 41, and its top end at y = 4 of 28, here 2.6 of 18
        assertThat(pixels[11 * 45 + 2 + 15]).isEqualTo(accent.getRGB());
        assertThat(pixels[2 + 15]).as("above it").isZero();
    }

    private static int[] pixels(Class<?> type) {
        return pixels(TinyDrawing.of(type));
    }

    /** With a border of two pixels. */
    private static int[] pixels(Icon icon) {
        int width = icon.getIconWidth() + 4;
        int height = icon.getIconHeight() + 4;
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB);
        Graphics2D graphics = image.createGraphics();
        JLabel beside = new JLabel();
        beside.setForeground(Color.MAGENTA);
        icon.paintIcon(beside, graphics, 2, 2);
        graphics.dispose();
        return image.getRGB(0, 0, width, height, null, 0, width);
    }
}
