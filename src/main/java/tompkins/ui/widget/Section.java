package tompkins.ui.widget;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Path2D;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.JToggleButton;
import javax.swing.SwingConstants;
import javax.swing.SwingUtilities;

/** A part of the side panel under a heading that folds it away. */
public final class Section extends Part {

    private static final int ARROW = 9;

    private final JToggleButton heading;

    /** A section that is open or folded. */
    public Section(String title, JComponent content, boolean open) {
        super(Rows.of("wrap 1, hidemode 3, gap 0 5", "[grow,fill]"));
        heading = new JToggleButton(title, new Drawing(ARROW, ARROW, Section::paintArrow), open);
        heading.setHorizontalAlignment(SwingConstants.LEADING);
        heading.putClientProperty(FlatClientProperties.BUTTON_TYPE, FlatClientProperties.BUTTON_TYPE_BORDERLESS);
        heading.putClientProperty(
                FlatClientProperties.STYLE,
                "font: bold; toolbar.selectedBackground: null; toolbar.hoverBackground: $Tompkins.hover;"
                        + " margin: 0,2,0,2");
        heading.setName(title);
        heading.getAccessibleContext().setAccessibleDescription(Texts.get("section.tip"));
        heading.addItemListener(event -> {
            content.setVisible(heading.isSelected());
            panel.revalidate();
            // after it has got its height
            SwingUtilities.invokeLater(this::comeIntoView);
        });
        content.setVisible(open);
        panel.add(heading);
        panel.add(content, "gapleft 6, gapright 4, gapbottom 2, wmin 0");
    }

    /** Scrolls until all of it is visible, or from its heading on if there is not enough room. */
    private void comeIntoView() {
        panel.scrollRectToVisible(new Rectangle(panel.getSize()));
        heading.scrollRectToVisible(new Rectangle(heading.getSize()));
    }

    /** A triangle that points down if open, to the right if folded. */
    private static void paintArrow(Graphics2D g, Component heading) {
        boolean open = ((AbstractButton) heading).isSelected();
        g.setColor(heading.getForeground());
        Path2D arrow = new Path2D.Double();
        arrow.moveTo(open ? 1 : 3, open ? 3 : 1);
        arrow.lineTo(open ? 8 : 3, open ? 3 : 8);
        arrow.lineTo(open ? 4.5 : 7.5, open ? 7.5 : 4.5);
        arrow.closePath();
        g.fill(arrow);
    }
}
