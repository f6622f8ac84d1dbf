package tompkins.ui.widget;

import java.awt.Component;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.accessibility.AccessibleContext;
import javax.swing.DefaultListCellRenderer;
import javax.swing.Icon;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JList;

/** Gives components names and explanations, for the mouse, for screen readers and for tests. */
public final class Naming {

    private static final int LONGEST_LINE = 60;

    private Naming() {}

    /** Gives a component a tooltip, or none if the text is empty. */
    public static void tip(JComponent component, String tip) {
        component.setToolTipText(tip.isEmpty() ? null : wrapped(tip));
    }

    /** Gives a component a name and a tooltip, which may be empty. */
    public static void name(JComponent component, String name, String tip) {
        component.setName(name);
        tip(component, tip);
        AccessibleContext accessible = component.getAccessibleContext();
        accessible.setAccessibleName(name);
        accessible.setAccessibleDescription(tip);
    }

    /**
     * Gives a component the text of a key as its name, and that of the key with {@code Tip} appended as its tooltip.
     */
    public static void name(JComponent component, String key) {
        name(component, Texts.get(key), Texts.get(key + "Tip"));
    }

    /**
     * Shows the items of a combo box by their names, and its own name if none is chosen; a letter chooses the next one
     * whose name begins with it.
     */
    public static <T> void items(JComboBox<T> box, Function<? super T, String> name) {
        items(box, name, item -> null);
    }

    /** As above, with a drawing before each name, or none where that is null. */
    public static <T> void items(
            JComboBox<T> box, Function<? super T, String> name, Function<? super T, Icon> drawing) {
        box.setRenderer(new DefaultListCellRenderer() {
            @Override
            @SuppressWarnings("unchecked") // the list is that of the box
            public Component getListCellRendererComponent(
                    JList<?> list, Object item, int index, boolean selected, boolean focused) {
                super.getListCellRendererComponent(
                        list, item == null ? box.getName() : name.apply((T) item), index, selected, focused);
                setIcon(item == null ? null : drawing.apply((T) item));
                return this;
            }
        });
        box.setKeySelectionManager((letter, items) -> {
            char wanted = Character.toLowerCase(letter);
            return IntStream.rangeClosed(1, box.getItemCount())
                    .map(step -> (box.getSelectedIndex() + step) % box.getItemCount())
                    .filter(index -> Character.toLowerCase(
                                    name.apply(box.getItemAt(index)).charAt(0))
                            == wanted)
                    .findFirst()
                    .orElse(-1);
        });
    }

    /** A tooltip in lines that are not too long, broken between words, and within words that are longer than a line. */
    public static String wrapped(String text) {
        return text.lines().flatMap(line -> lines(line).stream()).collect(Collectors.joining("\n"));
    }

    private static List<String> lines(String text) {
        List<String> lines = new ArrayList<>();
        String rest = text;
        while (rest.length() > LONGEST_LINE) {
            int space = rest.lastIndexOf(' ', LONGEST_LINE);
            int end = space > 0 ? space : LONGEST_LINE;
            lines.add(rest.substring(0, end));
            rest = rest.substring(end).stripLeading();
        }
        lines.add(rest);
        return lines;
    }
}
