package tompkins.ui.widget;

import java.awt.Dimension;
import javax.swing.JButton;

/** A button that says the same in fewer words where there is no room for all of them. */
public final class FittingButton extends JButton {

    private static final long serialVersionUID = 1;

    private final String full;
    private final String brief;

    /** A button with all its words, which become fewer if its width is not enough. */
    public FittingButton(String full, String brief) {
        super(full);
        this.full = full;
        this.brief = brief;
    }

    @Override
    public Dimension getPreferredSize() {
        return sizeWith(full);
    }

    @Override
    public Dimension getMinimumSize() {
        return sizeWith(brief);
    }

    @Override
    public Dimension getMaximumSize() {
        return sizeWith(full);
    }

    private Dimension sizeWith(String text) {
        Dimension size = super.getPreferredSize();
        size.width += textWidth(text) - textWidth(getText());
        return size;
    }

    private int textWidth(String text) {
        return getFontMetrics(getFont()).stringWidth(text);
    }

    @Override
    public void setBounds(int x, int y, int width, int height) {
        super.setBounds(x, y, width, height);
        setText(width < getPreferredSize().width ? brief : full);
    }
}
