package tompkins.ui.widget;

import com.formdev.flatlaf.ui.FlatUIUtils;
import java.awt.Graphics;
import javax.swing.JLabel;
import tompkins.image.PictureLabel;

/** A line that leaves out its last parts where it has no room, and is not cut in a word; its tooltip has all. */
@SuppressWarnings("serial") // never written to a stream
public final class ShortLabel extends JLabel {

    /** An empty line with a name. */
    public ShortLabel(String name) {
        super(" ");
        setName(name);
    }

    @Override
    public void setText(String text) {
        super.setText(text);
        Naming.tip(this, text);
    }

    @Override
    protected void paintComponent(Graphics g) {
        String fitting = PictureLabel.shortened(getText(), g.getFontMetrics(getFont()), getWidth());
        if (fitting.equals(getText())) {
            super.paintComponent(g);
        } else {
            g.setColor(getForeground());
            FlatUIUtils.drawString(this, g, fitting, 0, getBaseline(getWidth(), getHeight()));
        }
    }
}
