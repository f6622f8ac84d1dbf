package tompkins.ui.widget;

import javax.swing.JComponent;
import javax.swing.JPanel;

/** A part of the window: what it is made of lies in a panel. */
public abstract class Part {

    /** Holds all of it. */
    protected final JPanel panel;

    /** A part that fills a panel. */
    protected Part(JPanel panel) {
        this.panel = panel;
    }

    /** What shows it, to be put into the window. */
    public final JComponent component() {
        return panel;
    }
}
