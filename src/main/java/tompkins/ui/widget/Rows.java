package tompkins.ui.widget;

import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;

/** The grids of the panels; panels one below the other share the same grid. */
public final class Rows {

    private Rows() {}

    /** A panel of one column. */
    public static JPanel column() {
        return of("wrap 1, hidemode 3, gap 6 5", "[grow,fill]");
    }

    /** Adds a component with its name before it; the last argument says where, as MigLayout writes it. */
    public static void add(JPanel rows, String name, JComponent component, String place) {
        JLabel label = new JLabel(name);
        label.setLabelFor(component);
        rows.add(label);
        rows.add(component, place);
    }

    /**
     * A panel as wide as the one that it is part of, without a border or a background of its own.
     *
     * @param layout its wrap and its gaps, as MigLayout writes them
     * @param columns its columns, as MigLayout writes them
     */
    public static JPanel of(String layout, String columns) {
        JPanel panel = new JPanel(new MigLayout("novisualpadding, insets 0, fillx, " + layout, columns));
        panel.setOpaque(false);
        return panel;
    }
}
