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
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.sceneobject.SceneObject;
import tompkins.studio.UniformBackground;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Surface;

class TypeIconTest {

    static Stream<Class<?>> types(Class<?> family) {
        return Hiding.types(family).stream();
    }

    static Stream<Class<?>> objectsAndSurfaces() {
        return Stream.of(SceneObject.class, Surface.class).flatMap(TypeIconTest::types);
    }

    @ParameterizedTest
    @MethodSource("objectsAndSurfaces")
    void objectsAndSurfacesHaveDrawings(Class<?> type) {
        assertThat(TypeIcon.of(type))
                .as("add a drawing of %s to TypeIcons.properties", type.getSimpleName())
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
        assertThat(TypeIcon.of(UniformBackground.class)).isNull();
    }

    /** With a border of two pixels. */
    private static int[] pixels(Class<?> type) {
        Icon icon = TypeIcon.of(type);
        BufferedImage image = new BufferedImage(30, 22, BufferedImage.TYPE_INT_ARGB);
        Graphics2D graphics = image.createGraphics();
        JLabel beside = new JLabel();
        beside.setForeground(Color.MAGENTA);
        icon.paintIcon(beside, graphics, 2, 2);
        graphics.dispose();
        return image.getRGB(0, 0, 30, 22, null, 0, 30);
    }
}
