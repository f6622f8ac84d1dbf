package tompkins.ui.number;

import java.util.List;
import javax.swing.DefaultComboBoxModel;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import tompkins.studio.Studio;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Updating;

/** Offers the numbers that a studio has, one of which can be chosen. */
public final class NumberChoice {

    private final JComboBox<NumberProperty> numbers = new JComboBox<>();
    private final Updating updating = new Updating();
    private List<NumberProperty> offered = List.of();
    private Studio offeredOf;

    /** A choice; {@code chosen} is called when the user chooses a number. */
    public NumberChoice(Runnable chosen) {
        Naming.name(numbers, "play.property");
        numbers.setRenderer(new DefaultListCellRenderer());
        numbers.addActionListener(event -> updating.unless(chosen));
    }

    /** What shows the choice. */
    public JComponent component() {
        return numbers;
    }

    /** The chosen number; null before a studio was shown. */
    public NumberProperty chosen() {
        return (NumberProperty) numbers.getSelectedItem();
    }

    /**
     * Offers the numbers of a studio; false if the chosen one is no longer among them, so that another one is chosen.
     */
    public boolean show(Studio studio) {
        if (offeredOf != null && NumberProperty.unchanged(offeredOf, studio)) {
            return true;
        }
        offeredOf = studio;
        List<NumberProperty> now = NumberProperty.of(studio);
        if (now.equals(offered)) {
            return true;
        }
        offered = now;
        NumberProperty before = chosen();
        boolean stays = now.contains(before);
        updating.during(() -> {
            numbers.setModel(new DefaultComboBoxModel<>(now.toArray(NumberProperty[]::new)));
            if (stays) {
                numbers.setSelectedItem(before);
            }
        });
        return stays;
    }

    /** Chooses a number as the user does; false if it is not offered. */
    public boolean choose(NumberProperty number) {
        boolean has = offered.contains(number);
        if (has) {
            numbers.setSelectedItem(number);
        }
        return has;
    }
}
