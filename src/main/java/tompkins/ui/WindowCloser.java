package tompkins.ui;

import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.List;
import javax.swing.JFrame;
import tompkins.ui.exchange.SceneOpener;
import tompkins.ui.file.BackgroundTask;
import tompkins.ui.widget.Messages;
import tompkins.ui.widget.Texts;

/** Closes a window, without losing what was changed or is being saved. */
final class WindowCloser extends WindowAdapter {

    private final JFrame frame;
    private final SceneOpener opener;
    private final Runnable closing;
    private final Runnable closed;

    /**
     * Closes a window when its user wants that.
     *
     * @param closing called before the window goes
     * @param closed ends what works for the window
     */
    WindowCloser(JFrame frame, SceneOpener opener, Runnable closing, Runnable closed) {
        this.frame = frame;
        this.opener = opener;
        this.closing = closing;
        this.closed = closed;
    }

    @Override
    public void windowClosing(WindowEvent event) {
        List<String> running = BackgroundTask.running(frame);
        if (running.isEmpty()) {
            opener.leaveScene(this::close);
        } else if (isToBeStopped(running.get(0))) {
            BackgroundTask.cancel(frame);
            BackgroundTask.whenIdle(frame, () -> opener.leaveScene(this::close));
        }
    }

    private boolean isToBeStopped(String task) {
        return Messages.tellAndAsk(
                        frame,
                        Texts.get("close.title"),
                        Texts.get("close.question", task),
                        Texts.get("close.stop"),
                        Texts.get("close.wait"))
                == 0;
    }

    private void close() {
        closing.run();
        frame.dispose();
    }

    @Override
    public void windowClosed(WindowEvent event) {
        closed.run();
    }
}
