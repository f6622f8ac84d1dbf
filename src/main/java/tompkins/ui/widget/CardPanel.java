package tompkins.ui.widget;

import java.awt.CardLayout;
import javax.swing.JComponent;
import javax.swing.JPanel;

/** Parts of which one is shown, in the room of the largest, so that nothing moves when another one is shown. */
public final class CardPanel extends Part {

    /** No parts yet. */
    public CardPanel() {
        super(new JPanel(new CardLayout()));
        panel.setOpaque(false);
    }

    /** Adds the part for a type. */
    public void add(Class<?> type, JComponent part) {
        JPanel card = Rows.column();
        card.add(part, "wmin 0, aligny top");
        panel.add(card, type.getName());
    }

    /** Shows the part for a type. */
    public void show(Class<?> type) {
        ((CardLayout) panel.getLayout()).show(panel, type.getName());
    }
}
