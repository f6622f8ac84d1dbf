package tompkins.ui.widget;

import com.formdev.flatlaf.FlatClientProperties;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.ButtonGroup;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JToggleButton;

/** A row of buttons of which one is chosen, at first the first. */
public final class ChoiceRow {

    /** The style of a button in a row of which one is chosen. */
    private static final String STYLE = "margin: 2,4,2,4; minimumWidth: 0; selectedBackground: $Component.accentColor;"
            + " selectedForeground: $Tompkins.chosen; focusedBorderColor: $Tompkins.chosen";

    private ChoiceRow() {}

    /**
     * A row for some values.
     *
     * @param text the text on the button of a value, which is its name, too
     * @param tip what its value means
     * @param chosen notified of each choice
     */
    public static <T> JComponent of(
            List<T> values,
            Function<? super T, String> text,
            Function<? super T, String> tip,
            Consumer<? super T> chosen) {
        JPanel row = Rows.of("gap 2", "[grow,fill]".repeat(values.size()));
        ButtonGroup group = new ButtonGroup();
        for (T value : values) {
            JToggleButton button = new JToggleButton(text.apply(value), group.getButtonCount() == 0);
            Naming.name(button, button.getText(), tip.apply(value));
            button.putClientProperty(FlatClientProperties.STYLE, STYLE);
            whenChosen(button, () -> chosen.accept(value));
            group.add(button);
            row.add(button, "wmin 0");
        }
        return row;
    }

    /** Does something when a button of a group is chosen: with the mouse, or by the arrow keys, which click nowhere. */
    public static void whenChosen(JToggleButton button, Runnable action) {
        button.addItemListener(event -> {
            if (button.isSelected()) {
                action.run();
            }
        });
    }
}
