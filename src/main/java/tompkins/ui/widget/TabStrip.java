package tompkins.ui.widget;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.util.EnumMap;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.BorderFactory;
import javax.swing.ButtonGroup;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JToggleButton;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import net.miginfocom.swing.MigLayout;

/** The strip under the photograph: its tabs, of which one is open, in a part of the window's height. */
public final class TabStrip extends Part {

    /** What there is a tab for. */
    public enum Tab {
        /** The ride. */
        RIDE,
        /** Measuring in the picture. */
        MEASURE,
        /** Numbers that run. */
        PLAY
    }

    /** The most that a tab takes of the window's height. */
    private static final double SHARE = 2 / 7.0;

    private final JPanel head = new JPanel(new MigLayout("novisualpadding, insets 2 6 0 6, fillx, gap 2 0"));
    private final Column column = new Column();
    private final ButtonGroup group = new ButtonGroup();
    private final Map<Tab, JToggleButton> buttons = new EnumMap<>(Tab.class);
    private final Map<Tab, Supplier<JComponent>> makers = new EnumMap<>(Tab.class);
    private final Map<Tab, Consumer<Boolean>> listeners = new EnumMap<>(Tab.class);
    private Tab open;

    /** A strip that is closed. */
    public TabStrip() {
        super(new Room());
        for (Tab tab : Tab.values()) {
            String text = Texts.get("strip." + tab);
            JToggleButton button = new JToggleButton(text);
            Naming.name(button, Texts.get("strip.name", text), Texts.get("strip." + tab + "Tip"));
            button.putClientProperty(FlatClientProperties.BUTTON_TYPE, FlatClientProperties.BUTTON_TYPE_TAB);
            ChoiceRow.whenChosen(button, () -> open(tab));
            group.add(button);
            buttons.put(tab, button);
            head.add(button, "wmin 0");
        }
        JButton cross = Buttons.of("strip.close", this::close);
        cross.setText("\u00d7");
        cross.putClientProperty(FlatClientProperties.BUTTON_TYPE, FlatClientProperties.BUTTON_TYPE_TOOLBAR_BUTTON);
        head.add(cross, "pushx, alignx right");
        JScrollPane scroll = new Scroll(column);
        panel.add(head, BorderLayout.NORTH);
        panel.add(scroll, BorderLayout.CENTER);
        panel.setVisible(false);
    }

    /**
     * Fills a tab.
     *
     * @param maker makes what it shows, when that is first wanted
     * @param listener notified when it is opened, and when it is closed; it shows and hides what was made
     */
    public void fill(Tab tab, Supplier<JComponent> maker, Consumer<Boolean> listener) {
        makers.put(tab, maker);
        listeners.put(tab, listener);
    }

    /** Opens a tab, and closes the one that was open. */
    public void open(Tab tab) {
        if (tab == open) {
            return;
        }
        Supplier<JComponent> maker = makers.remove(tab);
        if (maker != null) {
            JComponent made = maker.get();
            // the look may have changed since it was made
            SwingUtilities.updateComponentTreeUI(made);
            column.add(made, "wmin 0");
        }
        Tab before = open;
        open = tab;
        if (before != null) {
            listeners.get(before).accept(false);
        }
        buttons.get(tab).setSelected(true);
        panel.setVisible(true);
        listeners.get(tab).accept(true);
        panel.revalidate();
    }

    /** Closes the tab that is open, and the strip with it. */
    public void close() {
        Tab before = open;
        open = null;
        group.clearSelection();
        panel.setVisible(false);
        if (before != null) {
            listeners.get(before).accept(false);
        }
    }

    /** Opens a tab, or closes it if it is open. */
    public void toggle(Tab tab) {
        if (!closeIfOpen(tab)) {
            open(tab);
        }
    }

    /** Closes a tab; false if it is not open. */
    public boolean closeIfOpen(Tab tab) {
        boolean was = tab == open;
        if (was) {
            close();
        }
        return was;
    }

    /** Scrolls what is too high; what becomes higher makes the strip higher. */
    private static final class Scroll extends JScrollPane {

        private static final long serialVersionUID = 1;

        Scroll(JComponent content) {
            super(content, VERTICAL_SCROLLBAR_AS_NEEDED, HORIZONTAL_SCROLLBAR_NEVER);
            setName("strip");
            setBorder(BorderFactory.createEmptyBorder());
        }

        @Override
        public boolean isValidateRoot() {
            return false;
        }
    }

    /** A panel with a line above it, in any look, which takes no more than its share of the window. */
    private static final class Room extends JPanel {

        private static final long serialVersionUID = 1;

        Room() {
            super(new BorderLayout());
        }

        @Override
        public void updateUI() {
            super.updateUI();
            setBorder(BorderFactory.createMatteBorder(1, 0, 0, 0, UIManager.getColor("Tompkins.line")));
        }

        @Override
        public Dimension getPreferredSize() {
            Dimension size = super.getPreferredSize();
            double most =
                    getRootPane() == null ? size.height : SHARE * getRootPane().getHeight();
            return new Dimension(size.width, (int) Math.min(size.height, most));
        }
    }
}
