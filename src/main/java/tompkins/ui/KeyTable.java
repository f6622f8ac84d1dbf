package tompkins.ui;

import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import tompkins.ui.widget.Texts;

/** The keys and what the mouse does, group by group: each beside what it means. */
final class KeyTable {

    private final JPanel panel = new JPanel(new MigLayout("novisualpadding, insets 0, wrap 2, gap 24 3"));

    KeyTable() {
        panel.setName("keys");
        Texts.get("help.keys").lines().forEach(this::add);
    }

    private void add(String line) {
        int tab = line.indexOf('\t');
        if (tab < 0) {
            addHeading(line);
        } else {
            panel.add(new JLabel(line.substring(0, tab)));
            panel.add(new JLabel(line.substring(tab + 1)));
        }
    }

    private void addHeading(String title) {
        JLabel heading = new JLabel(title);
        heading.putClientProperty("FlatLaf.style", "font: bold");
        panel.add(heading, panel.getComponentCount() == 0 ? "span 2" : "span 2, gaptop 9");
    }

    JComponent component() {
        return panel;
    }
}
