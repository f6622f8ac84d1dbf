package tompkins.ui;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import tompkins.ui.widget.Texts;

/** The keys and what the mouse does, group by group: each beside what it means. */
final class KeyTable {

    private final JPanel panel = new JPanel(new MigLayout("novisualpadding, insets 0, wrap 2, gap 24 0"));

    /** A table that begins with some menu items, which all have keys. */
    KeyTable(List<JMenuItem> items) {
        panel.setName("keys");
        addHeading(Texts.get("help.menus"));
        for (JMenuItem item : items) {
            add(text(item.getAccelerator()), item.getText().replace("\u2026", ""));
        }
        Texts.get("help.keys").lines().forEach(this::add);
    }

    /** Like {@code Ctrl+Shift+S}. */
    private static String text(KeyStroke key) {
        String modifiers = InputEvent.getModifiersExText(key.getModifiers());
        return (modifiers.isEmpty() ? "" : modifiers + "+") + KeyEvent.getKeyText(key.getKeyCode());
    }

    private void add(String line) {
        int tab = line.indexOf('\t');
        if (tab < 0) {
            addHeading(line);
        } else {
            add(line.substring(0, tab), line.substring(tab + 1));
        }
    }

    private void add(String key, String meaning) {
        panel.add(new JLabel(key));
        panel.add(new JLabel(meaning));
    }

    private void addHeading(String title) {
        JLabel heading = new JLabel(title);
        heading.putClientProperty(FlatClientProperties.STYLE, "font: bold");
        panel.add(heading, panel.getComponentCount() == 0 ? "span 2" : "span 2, gaptop 5");
    }

    JComponent component() {
        return panel;
    }
}
