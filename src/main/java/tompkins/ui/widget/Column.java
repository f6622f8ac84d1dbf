package tompkins.ui.widget;

import java.awt.Dimension;
import java.awt.Rectangle;
import javax.swing.BorderFactory;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.ScrollPaneConstants;
import javax.swing.Scrollable;
import javax.swing.SwingConstants;
import net.miginfocom.swing.MigLayout;

/** A column of parts that is as wide as its scroll pane and as high as its parts. */
@SuppressWarnings("serial") // never written to a stream
public final class Column extends JPanel implements Scrollable {

    private static final int STEP = 20;

    /** An empty column. */
    public Column() {
        super(new MigLayout("novisualpadding, insets 6 6 4 6, fillx, wrap 1, hidemode 3, gap 0 0", "[grow,fill]"));
    }

    /** Puts it into a scroll pane with a name, which may take any height. */
    public JScrollPane scrolled(String name) {
        JScrollPane scroll = new JScrollPane(
                this,
                // so that nothing moves sideways when there is more, or less, than fits
                ScrollPaneConstants.VERTICAL_SCROLLBAR_ALWAYS,
                ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
        scroll.setName(name);
        scroll.setBorder(BorderFactory.createEmptyBorder());
        // beside another one it takes the room that is left
        scroll.setMinimumSize(new Dimension(0, 0));
        return scroll;
    }

    @Override
    public Dimension getPreferredScrollableViewportSize() {
        return getPreferredSize();
    }

    @Override
    public int getScrollableUnitIncrement(Rectangle visible, int orientation, int direction) {
        return STEP;
    }

    @Override
    public int getScrollableBlockIncrement(Rectangle visible, int orientation, int direction) {
        return orientation == SwingConstants.VERTICAL ? visible.height : visible.width;
    }

    @Override
    public boolean getScrollableTracksViewportWidth() {
        return true;
    }

    @Override
    public boolean getScrollableTracksViewportHeight() {
        return false;
    }
}
