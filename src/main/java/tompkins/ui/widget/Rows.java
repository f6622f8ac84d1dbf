package tompkins.ui.widget;

import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;

/** The grid that all panels share, so that their columns stand under each other. */
public final class Rows {

    private Rows() {}

    /** A panel of three columns: name, control, field. */
    public static JPanel panel() {
        JPanel panel = new JPanel(new MigLayout(
                "novisualpadding, insets 0, fillx, wrap 3, hidemode 3, gap 6 5", "[pref][grow,fill][pref!]"));
        panel.setOpaque(false);
        return panel;
    }

    /** A panel of one column. */
    public static JPanel column() {
        JPanel panel = new JPanel(
                new MigLayout("novisualpadding, insets 0, fillx, wrap 1, hidemode 3, gap 6 5", "[grow,fill]"));
        panel.setOpaque(false);
        return panel;
    }
}
