package tompkins.ui.help;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Texts;

/** The keys and the mouse, group by group in two columns or one, each beside its meaning. */
public final class KeyTable extends Part {

    /** A table that begins with some menu items, which all have keys. */
    public KeyTable(List<JMenuItem> items) {
        super(new JPanel(new MigLayout("novisualpadding, insets 0, gap 32 0")));
        panel.setName("keys");
        List<String> lines = new ArrayList<>();
        lines.add(Texts.get("help.menus"));
        for (JMenuItem item : items) {
            lines.add(text(item.getAccelerator()) + "\t" + menu(item)
                    + item.getText().replace("\u2026", ""));
        }
        Texts.get("help.keys").lines().forEach(lines::add);
        int middle = middle(lines);
        panel.add(column(lines.subList(0, middle)), "aligny top");
        panel.add(column(lines.subList(middle, lines.size())), "aligny top");
    }

    /** The menu in a menu that holds an item, whose name it needs to be understood; empty if none does. */
    private static String menu(JMenuItem item) {
        return item.getParent() instanceof JPopupMenu popup
                        && popup.getInvoker() instanceof JMenu menu
                        && !menu.isTopLevelMenu()
                ? menu.getText() + ": "
                : "";
    }

    /** The key in words, such as {@code Ctrl+Shift+S}. */
    private static String text(KeyStroke key) {
        String modifiers = InputEvent.getModifiersExText(key.getModifiers());
        return (modifiers.isEmpty() ? "" : modifiers + "+") + KeyEvent.getKeyText(key.getKeyCode());
    }

    private static boolean isHeading(String line) {
        return line.indexOf('\t') < 0;
    }

    /** The first line of the group that begins nearest to the middle. */
    private static int middle(List<String> lines) {
        return IntStream.range(1, lines.size())
                .filter(line -> isHeading(lines.get(line)))
                .boxed()
                .min(Comparator.comparingInt(line -> Math.abs(2 * line - lines.size())))
                .orElse(lines.size());
    }

    private static JComponent column(List<String> lines) {
        JPanel column = new JPanel(new MigLayout("novisualpadding, insets 0, wrap 2, gap 16 0"));
        for (String line : lines) {
            if (isHeading(line)) {
                JLabel heading = new JLabel(line);
                heading.putClientProperty(FlatClientProperties.STYLE, "font: bold");
                column.add(heading, column.getComponentCount() == 0 ? "span 2" : "span 2, gaptop 9");
            } else {
                int tab = line.indexOf('\t');
                column.add(new JLabel(line.substring(0, tab)));
                column.add(new JLabel(line.substring(tab + 1)));
            }
        }
        return column;
    }
}
