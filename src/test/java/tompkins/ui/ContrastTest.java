package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Component;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import javax.swing.JComponent;
import javax.swing.JToggleButton;
import javax.swing.UIManager;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import tompkins.spacetime.SpeedScale;
import tompkins.study.ChartStyle;
import tompkins.ui.widget.ChoiceRow;
import tompkins.ui.widget.Look;

/** Text stands out from what is behind it, as the Web Content Accessibility Guidelines 2 measure it, in all looks. */
@LightLook
class ContrastTest {

    /** Level AA of the guidelines, for text of any size. */
    private static final double LEAST = 4.5;

    /** The same level for marks. */
    private static final double LEAST_OF_MARKS = 3;

    private static double contrast(Color one, Color other) {
        double first = luminance(one);
        double second = luminance(other);
        return (Math.max(first, second) + 0.05) / (Math.min(first, second) + 0.05);
    }

    private static double luminance(Color colour) {
        double[] linear = DoubleStream.of(colour.getRed(), colour.getGreen(), colour.getBlue())
                .map(level -> level / 255)
                .map(level -> level <= 0.03928 ? level / 12.92 : Math.pow((level + 0.055) / 1.055, 2.4))
                .toArray();
        return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2];
    }

    /** The contrast of what is painted in the middle of a component with the colour that is there most often. */
    private static double painted(JToggleButton button) {
        button.setSize(120, 30);
        BufferedImage image = new BufferedImage(120, 30, BufferedImage.TYPE_INT_RGB);
        button.paint(image.createGraphics());
        List<Color> colours = new ArrayList<>();
        for (int y = 6; y < 24; y++) {
            for (int x = 10; x < 110; x++) {
                colours.add(new Color(image.getRGB(x, y)));
            }
        }
        Color ground = colours.stream()
                .distinct()
                .max((a, b) -> Collections.frequency(colours, a) - Collections.frequency(colours, b))
                .orElseThrow();
        return colours.stream()
                .mapToDouble(colour -> contrast(colour, ground))
                .max()
                .orElseThrow();
    }

    @ParameterizedTest
    @EnumSource
    void theChosenScaleIsRead(Look look) {
        look.install();
        JComponent row = ChoiceRow.of(List.of(SpeedScale.values()), Enum::name, Enum::name, scale -> {});
        for (Component part : row.getComponents()) {
            JToggleButton button = (JToggleButton) part;
            button.doClick();
            assertThat(painted(button)).as("%s, %s", look, button.getText()).isGreaterThanOrEqualTo(LEAST);
        }
    }

    @ParameterizedTest
    @EnumSource
    void textIsRead(Look look) {
        look.install();
        Color panel = UIManager.getColor("Panel.background");
        for (String text : List.of("Label.foreground", "Tompkins.note", "Tompkins.error")) {
            assertThat(contrast(UIManager.getColor(text), panel))
                    .as("%s, %s", look, text)
                    .isGreaterThanOrEqualTo(LEAST);
        }
        for (String kind : List.of("Button", "ToggleButton", "TextField", "ComboBox", "ToolTip")) {
            assertThat(contrast(UIManager.getColor(kind + ".foreground"), UIManager.getColor(kind + ".background")))
                    .as("%s, %s", look, kind)
                    .isGreaterThanOrEqualTo(LEAST);
        }
    }

    @ParameterizedTest
    @EnumSource
    void whatCanBeUsedStandsOut(Look look) {
        look.install();
        Color panel = UIManager.getColor("Panel.background");
        for (String edge : List.of(
                "Component.borderColor",
                "Button.borderColor",
                "Slider.trackColor",
                "ScrollBar.thumb",
                "ComboBox.buttonArrowColor",
                "CheckBox.icon.borderColor")) {
            assertThat(contrast(UIManager.getColor(edge), panel))
                    .as("%s, %s", look, edge)
                    .isGreaterThanOrEqualTo(LEAST_OF_MARKS);
        }
        assertThat(contrast(UIManager.getColor("Component.focusColor"), panel))
                .as("%s, focus", look)
                .isGreaterThanOrEqualTo(LEAST_OF_MARKS);
    }

    @Test
    void aChartInADarkRoomIsRead() {
        ChartStyle style = ChartStyle.DARK;
        assertThat(contrast(style.ink(), style.paper())).isGreaterThanOrEqualTo(LEAST);
        assertThat(IntStream.range(0, 8).mapToObj(style::curve))
                .allSatisfy(curve -> assertThat(contrast(curve, style.paper())).isGreaterThanOrEqualTo(LEAST_OF_MARKS));
    }
}
