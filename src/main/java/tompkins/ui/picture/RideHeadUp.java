package tompkins.ui.picture;

import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.util.function.Supplier;
import javax.swing.UIManager;
import tompkins.image.PictureLabel;

/** The line at the top of the picture that says how a ride goes. */
public final class RideHeadUp implements Overlay {

    private final Supplier<String> line;

    /** Shows the line that a supplier writes; nothing if it is empty. */
    public RideHeadUp(Supplier<String> line) {
        this.line = line;
    }

    @Override
    public void paint(Graphics2D g, Picture picture, Rectangle bounds, Rectangle visible, Rectangle free) {
        String text = line.get();
        if (!text.isEmpty()) {
            Font font = UIManager.getFont("Label.font").deriveFont(Font.BOLD);
            PictureLabel.paint(g, font, text, free, PictureLabel.Corner.TOP_MIDDLE);
        }
    }
}
