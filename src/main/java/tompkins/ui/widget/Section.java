package tompkins.ui.widget;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.geom.Path2D;
import javax.swing.AbstractButton;
import javax.swing.Icon;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import javax.swing.SwingConstants;
import javax.swing.SwingUtilities;

/** A part of the side panel under a heading that folds it away. */
public final class Section {

    private static final int ARROW = 9;

    private final JPanel panel = Rows.of("wrap 1, hidemode 3, gap 0 6", "[grow,fill]");
    private final JToggleButton heading;

    /** A section that is open or folded. */
    public Section(String title, JComponent content, boolean open) {
        heading = new JToggleButton(title, new Arrow(), open);
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
        panel.add(content, "gapleft 6, gapright 4, gapbottom 4, wmin 0");
    }

    /** Heading and content. */
    public JComponent component() {
        return panel;
    }

    /** Scrolls until all of it is visible, or from its heading on if there is not enough room. */
    private void comeIntoView() {
        panel.scrollRectToVisible(new Rectangle(panel.getSize()));
        heading.scrollRectToVisible(new Rectangle(heading.getSize()));
    }

    /** A triangle that points down if open, to the right if folded. */
    private static final class Arrow implements Icon {

        @Override
        public void paintIcon(Component component, Graphics graphics, int x, int y) {
            Graphics2D g = (Graphics2D) graphics.create(x, y, ARROW, ARROW);
            g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
            g.setColor(component.getForeground());
            Path2D arrow = new Path2D.Double();
            if (((AbstractButton) component).isSelected()) {
                arrow.moveTo(1, 3);
                arrow.lineTo(8, 3);
                arrow.lineTo(4.5, 7.5);
            } else {
                arrow.moveTo(3, 1);
                arrow.lineTo(3, 8);
                arrow.lineTo(7.5, 4.5);
            }
            arrow.closePath();
            g.fill(arrow);
            g.dispose();
        }

        @Override
        public int getIconWidth() {
            return ARROW;
        }

        @Override
        public int getIconHeight() {
            return ARROW;
        }
    }
}
