package tompkins.ui.ray;

import java.awt.Color;
import java.awt.Font;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.List;
import javax.swing.JTextPane;
import javax.swing.UIManager;
import javax.swing.text.AttributeSet;
import javax.swing.text.BadLocationException;
import javax.swing.text.DefaultCaret;
import javax.swing.text.DefaultStyledDocument;
import javax.swing.text.SimpleAttributeSet;
import javax.swing.text.StyleConstants;
import javax.swing.text.StyledDocument;
import javax.swing.text.TabSet;
import javax.swing.text.TabStop;
import tompkins.io.FactText;
import tompkins.ui.widget.WrappingArea;

/** The history of a ray as a text: headings, and under each its facts in two columns. Can be selected and copied. */
@SuppressWarnings("serial") // never written to a stream
final class StoryPane extends JTextPane {

    /** Widths in sizes of the type. */
    private static final double LABELS = 6.5;

    private static final double BRANCH_INDENT = 1;
    private static final float HEADING_GAP = 0.5f;

    private transient List<FactText.Line> lines = List.of();

    /** Empty at first. */
    StoryPane() {
        setEditable(false);
        WrappingArea.behaveWrapped(this);
        addFocusListener(new FocusAdapter() {
            @Override
            public void focusGained(FocusEvent event) {
                // the caret of a text that is not edited does not show by itself where the keys are
                getCaret().setVisible(true);
            }
        });
    }

    @Override
    public void updateUI() {
        super.updateUI();
        setBorder(null);
        setOpaque(false);
        ((DefaultCaret) getCaret()).setUpdatePolicy(DefaultCaret.NEVER_UPDATE);
        if (lines != null) {
            write();
        }
    }

    /** Shows a history. */
    void show(List<FactText.Line> history) {
        if (!history.equals(lines)) {
            lines = history;
            write();
        }
    }

    private void write() {
        Font font = UIManager.getFont("small.font");
        Color strong = UIManager.getColor("Label.foreground");
        Color soft = UIManager.getColor("Tompkins.note");
        StyledDocument text = new DefaultStyledDocument();
        for (FactText.Line line : lines) {
            float indent = (float) (BRANCH_INDENT * line.branch() * font.getSize());
            boolean isFirst = text.getLength() == 0;
            add(text, isFirst ? "" : "\n", font, soft, false);
            int start = text.getLength();
            boolean isBold = line.isHeading();
            add(text, line.name(), font, isBold ? strong : soft, isBold);
            add(text, line.value().isEmpty() ? "" : "\t" + line.value(), font, strong, false);
            AttributeSet layout = isBold ? headingLine(font, indent, isFirst) : factLine(font, indent);
            text.setParagraphAttributes(start, 1, layout, true);
        }
        setDocument(text);
    }

    private static void add(StyledDocument text, String words, Font font, Color colour, boolean isBold) {
        SimpleAttributeSet style = new SimpleAttributeSet();
        StyleConstants.setFontFamily(style, font.getFamily());
        StyleConstants.setFontSize(style, font.getSize());
        StyleConstants.setForeground(style, colour);
        StyleConstants.setBold(style, isBold);
        try {
            text.insertString(text.getLength(), words, style);
        } catch (BadLocationException impossible) {
            throw new IllegalStateException(impossible);
        }
    }

    private static AttributeSet headingLine(Font font, float indent, boolean isFirst) {
        SimpleAttributeSet line = new SimpleAttributeSet();
        StyleConstants.setLeftIndent(line, indent);
        StyleConstants.setSpaceAbove(line, isFirst ? 0 : HEADING_GAP * font.getSize());
        return line;
    }

    /** The values are in a column of their own, even if one needs a second line. */
    private static AttributeSet factLine(Font font, float indent) {
        float labels = (float) (LABELS * font.getSize());
        SimpleAttributeSet line = new SimpleAttributeSet();
        StyleConstants.setLeftIndent(line, indent + labels);
        StyleConstants.setFirstLineIndent(line, -labels);
        StyleConstants.setTabSet(line, new TabSet(new TabStop[] {new TabStop(0)}));
        return line;
    }
}
