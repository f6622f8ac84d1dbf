package tompkins.ui.widget;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.geom.Rectangle2D;
import javax.swing.JComponent;
import javax.swing.JToggleButton;
import javax.swing.JViewport;
import javax.swing.plaf.basic.BasicGraphicsUtils;
import javax.swing.text.BadLocationException;
import javax.swing.text.JTextComponent;
import javax.swing.text.Utilities;

/** A text of which a few lines are seen, and with a button all of it. */
public final class FoldedText extends Part {

    private static final int LINES = 2;
    private static final String ELLIPSIS = " \u2026";

    private final Note note = new Note("");
    private final JTextComponent text = (JTextComponent) note.component();
    private final JToggleButton more = new JToggleButton();
    private final JViewport seen = new Lines();

    /** A folded text with a name, without words yet. */
    public FoldedText(String name) {
        super(Rows.column());
        text.setName(name);
        seen.setOpaque(false);
        seen.setView(text);
        more.putClientProperty(FlatClientProperties.BUTTON_TYPE, FlatClientProperties.BUTTON_TYPE_TOOLBAR_BUTTON);
        more.putClientProperty(FlatClientProperties.STYLE, "font: $small.font; margin: 0,4,0,4; minimumWidth: 0");
        more.addItemListener(event -> fold());
        panel.add(seen, "wmin 0");
        fold();
        setText("");
    }

    private void fold() {
        String key = more.isSelected() ? "remarks.less" : "remarks.more";
        more.setText(Texts.get(key));
        Naming.name(more, Texts.get(key), Texts.get("remarks.moreTip"));
        panel.revalidate();
    }

    /** The button that unfolds it, to be put near it. */
    public JComponent button() {
        return more;
    }

    /** What it says. */
    public String text() {
        return note.text();
    }

    /** Says something else, folded. */
    public void setText(String text) {
        note.setText(text);
        more.setSelected(false);
        panel.setVisible(!text.isEmpty());
        more.setVisible(!text.isEmpty());
        panel.revalidate();
    }

    /** Shows the first lines, or all of them; the button is there where it has something to do. */
    private final class Lines extends JViewport {

        private static final long serialVersionUID = 1;

        @Override
        public Dimension getPreferredSize() {
            Dimension size = text.getPreferredSize();
            return new Dimension(size.width, more.isSelected() ? size.height : Math.min(size.height, few()));
        }

        private int few() {
            return LINES * text.getFontMetrics(text.getFont()).getHeight();
        }

        @Override
        public void setBounds(int x, int y, int width, int height) {
            super.setBounds(x, y, width, height);
            // the height of wrapped text is known only when its width is
            if (text.getWidth() != width) {
                text.setSize(width, height);
            }
            more.setVisible(more.isSelected() || text.getPreferredSize().height > few());
            if (getPreferredSize().height != height) {
                panel.revalidate();
            }
        }

        @Override
        public Dimension getMinimumSize() {
            return new Dimension(0, getPreferredSize().height);
        }

        /** Ends the last line with an ellipsis, after a whole word, where more follows. */
        @Override
        protected void paintChildren(Graphics graphics) {
            super.paintChildren(graphics);
            if (getHeight() < text.getPreferredSize().height) {
                FontMetrics font = text.getFontMetrics(text.getFont());
                int left = cutWord(getWidth() - font.stringWidth(ELLIPSIS));
                graphics.setColor(panel.getBackground());
                graphics.fillRect(left, getHeight() - font.getHeight(), getWidth() - left, font.getHeight());
                graphics.setColor(text.getForeground());
                graphics.setFont(text.getFont());
                BasicGraphicsUtils.drawString(
                        text, (Graphics2D) graphics, ELLIPSIS, left, getHeight() - font.getDescent());
            }
        }

        /** Where the word of the last line begins that would be cut at a place. */
        private int cutWord(int place) {
            try {
                int cut = text.viewToModel2D(new Point(place, getHeight() - 1));
                Rectangle2D word = text.modelToView2D(Utilities.getWordStart(text, cut));
                boolean beganBefore = word.getY() < text.modelToView2D(cut).getY();
                return beganBefore ? 0 : (int) word.getX();
            } catch (BadLocationException impossible) {
                throw new IllegalStateException(impossible);
            }
        }
    }
}
