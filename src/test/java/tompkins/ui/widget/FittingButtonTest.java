package tompkins.ui.widget;

import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.FlatClientProperties;
import java.util.stream.Stream;
import javax.swing.Box;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import tompkins.ui.Components;
import tompkins.ui.LayoutProblems;

class FittingButtonTest {

    @AfterAll
    static void restore() {
        Look.LIGHT.install();
    }

    /** The menus keep their words; the button beside them gives up some of its own, and takes them back. */
    @ParameterizedTest
    @EnumSource(Look.class)
    void theButtonGivesWayInANarrowBar(Look look) {
        look.install();
        JMenuBar bar = new JMenuBar();
        Stream.of("File", "Examples", "Lessons", "Edit", "Play", "View", "Help")
                .forEach(name -> bar.add(new JMenu(name)));
        bar.add(Box.createHorizontalGlue());
        FittingButton button = new FittingButton("Ride through this scene (F6)", "Ride (F6)");
        button.putClientProperty(FlatClientProperties.STYLE, "font: bold; margin: 1,10,1,10");
        bar.add(button);
        int wide = bar.getPreferredSize().width;
        int saved = button.getPreferredSize().width - button.getMinimumSize().width;
        assertThat(saved).isPositive();
        for (int width : new int[] {wide, wide - 1, wide - saved, wide, wide - saved / 5, wide + 400}) {
            Components.layOut(bar, width);
            assertThat(LayoutProblems.in(bar)).as(width + " of " + wide).isEmpty();
            assertThat(button.getText()).isEqualTo(width < wide ? "Ride (F6)" : "Ride through this scene (F6)");
        }
    }
}
