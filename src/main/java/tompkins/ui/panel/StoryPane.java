package tompkins.ui.panel;

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
import tompkins.ui.picture.RayStory;
import tompkins.ui.widget.WrappedText;

/** The story of a ray as a text: headings, and under each its facts in two columns. Can be selected and copied. */
@SuppressWarnings("serial") // never written to a stream
final class StoryPane extends JTextPane {

    /** Widths in sizes of the type. */
    private static final double LABELS = 6.5;

    private static final double BRANCH_INDENT = 1;
    private static final float HEADING_GAP = 0.5f;

    private transient List<RayStory.Step> steps = List.of();

    /** Empty at first. */
    StoryPane() {
        setEditable(false);
        WrappedText.prepare(this);
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
        if (steps != null) {
            write();
        }
    }

    /** Shows a story. */
    void show(List<RayStory.Step> story) {
        if (!story.equals(steps)) {
            steps = story;
            write();
        }
    }

    private void write() {
        Font font = UIManager.getFont("small.font");
        Color strong = UIManager.getColor("Label.foreground");
        Color soft = UIManager.getColor("Tompkins.note");
        StyledDocument text = new DefaultStyledDocument();
        for (RayStory.Step step : steps) {
            float indent = (float) (BRANCH_INDENT * step.branch() * font.getSize());
            boolean isFirst = text.getLength() == 0;
            add(text, isFirst ? "" : "\n", font, strong, true);
            int heading = text.getLength();
            add(text, step.heading(), font, strong, true);
            text.setParagraphAttributes(heading, 1, headingLine(font, indent, isFirst), true);
            for (RayStory.Fact fact : step.facts()) {
                add(text, "\n", font, soft, false);
                int line = text.getLength();
                add(text, fact.label() + "\t", font, soft, false);
                add(text, fact.value(), font, strong, false);
                text.setParagraphAttributes(line, 1, factLine(font, indent), true);
            }
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
