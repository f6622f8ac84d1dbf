package tompkins.ui.compare;

import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import javax.swing.JFrame;
import javax.swing.JRootPane;
import javax.swing.KeyStroke;
import tompkins.ui.picture.PictureCanvas;
import tompkins.ui.widget.Keys;

/** The key that shows the other of two compared pictures alone as long as it is held. */
public final class PeekKey {

    private PeekKey() {}

    /** Lets the key work in a window with a canvas. */
    public static void bind(JFrame frame, PictureCanvas canvas) {
        JRootPane pane = frame.getRootPane();
        Keys.bind(pane, KeyStroke.getKeyStroke("F8"), () -> canvas.setOtherAlone(true));
        Keys.bind(pane, KeyStroke.getKeyStroke("released F8"), () -> canvas.setOtherAlone(false));
        frame.addWindowFocusListener(new WindowAdapter() {
            @Override
            public void windowLostFocus(WindowEvent event) {
                // the key is released elsewhere
                canvas.setOtherAlone(false);
            }
        });
    }
}
