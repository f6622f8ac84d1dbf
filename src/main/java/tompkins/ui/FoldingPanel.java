package tompkins.ui;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Insets;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import tompkins.ui.picture.Picture;
import tompkins.ui.widget.Look;

/**
 * The room beside the photograph. The panel comes into it when there is time, or as soon as it is needed: to make it
 * and lay it out takes half a second, for which the first picture need not wait.
 */
final class FoldingPanel {

    /** The least width of the photograph, in sizes of the type. */
    private static final double LEAST_PICTURE = 18;

    private final JPanel room = new JPanel(new BorderLayout());
    private final Supplier<SidePanel> maker;
    private SidePanel panel;
    private Picture shown;
    private JComponent window;
    private Consumer<Boolean> whenFolding;
    private boolean narrow;

    /** Whether the panel is hidden because the window is narrow. */
    private boolean folded;

    /** An empty room for a panel that will be made. */
    FoldingPanel(Supplier<SidePanel> maker) {
        this.maker = maker;
    }

    JComponent component() {
        return room;
    }

    /** Whether the panel is in its room. */
    boolean isThere() {
        return panel != null && panel.component().isVisible();
    }

    /** The panel, which comes into its room now if it is not there yet. */
    SidePanel panel() {
        if (panel == null) {
            panel = maker.get();
            panel.setWhenWidthChanges(() -> fit(panel.width()));
            if (shown != null) {
                panel.show(shown);
            }
            fill(panel.component());
        }
        return panel;
    }

    /** Lays out the panel before it is shown, because the heights of its texts follow from their widths. */
    private void fill(JComponent content) {
        content.setVisible(false);
        room.add(content);
        fitToLook();
        Insets edges = room.getInsets();
        int width = room.getPreferredSize().width - edges.left - edges.right;
        content.setBounds(edges.left, edges.top, width, room.getHeight() - edges.top - edges.bottom);
        SwingUtilities.invokeLater(() -> content.setVisible(true));
    }

    /** Shows the messages about the picture on the screen, as soon as the panel is there. */
    void show(Picture picture) {
        shown = picture;
        if (panel != null) {
            panel.show(picture);
        }
    }

    /** Whether the panel is shown, or would be if there were room. */
    boolean isWanted() {
        return room.isVisible() || folded;
    }

    /** Shows the panel, or hides it. */
    void setShown(boolean shown) {
        setFolded(false);
        room.setVisible(shown);
    }

    /** Shows the panel if it is hidden, and hides it if it is shown. */
    void toggle() {
        setShown(!room.isVisible());
    }

    /**
     * Folds the panel whenever the window becomes so narrow that no room is left for the photograph, and brings it back
     * when there is room again. The user may {@link #toggle} it meanwhile.
     *
     * @param content what the photograph shares with this room
     * @param folding notified when the panel is folded, and when it is not any more
     */
    void fitInto(JComponent content, Consumer<Boolean> folding) {
        window = content;
        whenFolding = folding;
        content.addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent event) {
                fit();
            }
        });
    }

    private void setFolded(boolean now) {
        if (now != folded) {
            folded = now;
            whenFolding.accept(now);
        }
    }

    private void fit() {
        boolean before = narrow;
        narrow = window.getWidth() < room.getPreferredSize().width + Look.pixels(LEAST_PICTURE);
        if (narrow && !before && room.isVisible()) {
            setFolded(true);
            room.setVisible(false);
        } else if (!narrow && folded) {
            toggle();
        }
    }

    /** Sets the sizes that do not follow the look by themselves. */
    void fitToLook() {
        if (panel == null) {
            fit(SidePanel.leastWidth());
        } else {
            panel.fitToLook();
        }
    }

    private void fit(int width) {
        room.setPreferredSize(new Dimension(width, 0));
        room.setBorder(BorderFactory.createMatteBorder(0, 1, 0, 0, UIManager.getColor("Tompkins.line")));
        room.revalidate();
        if (window != null && window.getWidth() > 0) {
            fit();
        }
    }
}
