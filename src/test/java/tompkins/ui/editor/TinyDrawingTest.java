package tompkins.ui.editor;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
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
import tompkins.shutter.Shutter;
import tompkins.shutter.SweepDirection;
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
    void shuttersAndTheirTimesAreDrawnAndToldApart() {
        List<Icon> icons = new ArrayList<>();
        Descriptions.members(Shutter.class)
                .forEach(shutter -> icons.add(TinyDrawing.of(shutter.getSimpleName(), 64, 28, Color.BLACK)));
        icons.add(TinyDrawing.of("exposure", 20, 16, Color.BLACK));
        for (SweepDirection direction : SweepDirection.values()) {
            icons.add(TinyDrawing.of("rolling-" + direction.name(), 20, 16, Color.BLACK));
        }
        assertThat(icons.stream()
                        .map(icon -> Arrays.stream(pixels(icon)).boxed().toList()))
                .hasSize(11)
                .doesNotHaveDuplicates();
    }

    @Test
    void wordsBeforeAStrokeSayHowItIsDrawn() {
        Look.LIGHT.install();
        Color accent = UIManager.getColor("Component.accentColor");
        int[] pixels = pixels(TinyDrawing.of("AperturePlaneShutter", 64, 28, null));
        // the shutter is a line 3 wide at x = 24, the detector one at x = 8, and the focus at x = 56 has gaps
        assertThat(pixels[16 * 68 + 26]).isEqualTo(accent.getRGB());
        assertThat(pixels[22 * 68 + 10]).isEqualTo(pixels[20 * 68 + 10]).isNotZero();
        assertThat(IntStream.range(7, 25)
                        .map(row -> pixels[row * 68 + 58])
                        .distinct()
                        .count())
                .isGreaterThan(1);
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
