package tompkins.ui;

import java.awt.Toolkit;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.Transferable;
import java.util.Optional;
import javax.swing.JFrame;
import tompkins.ui.file.BackgroundTask;
import tompkins.ui.file.ImageSelection;
import tompkins.ui.model.StudioModel;
import tompkins.ui.picture.Picture;
import tompkins.ui.picture.ScreenPicture;
import tompkins.ui.widget.Messages;
import tompkins.ui.widget.Texts;

/** Copies the photograph, or the command line that takes it, for other programs. */
final class ClipboardActions {

    private final JFrame frame;
    private final StudioModel model;
    private final PhotographView view;
    private final CommandLineWriter commandLine;
    private final StatusBar status;

    ClipboardActions(
            JFrame frame, StudioModel model, PhotographView view, CommandLineWriter commandLine, StatusBar status) {
        this.frame = frame;
        this.model = model;
        this.view = view;
        this.commandLine = commandLine;
        this.status = status;
    }

    /** Puts the picture on the screen on the clipboard, in its own size. */
    void copyPicture() {
        Picture picture = view.canvas().shown().now();
        if (picture != null) {
            BackgroundTask.find(
                    frame,
                    Texts.get("file.copying"),
                    () -> ScreenPicture.levels(picture),
                    image -> toClipboard(new ImageSelection(image), Texts.get("file.pictureCopied")));
        }
    }

    /** Puts the command line that takes this photograph on the clipboard. */
    void copyCommandLine() {
        Optional<String> command = commandLine.of(model.studio(), model.opened(), model.file());
        if (command.isEmpty()) {
            // the clipboard may still hold the command of another photograph
            Messages.error(frame, Texts.get(model.file() == null ? "file.copyNeedsFile" : "file.saveFirst"));
            return;
        }
        toClipboard(new StringSelection(command.get()), Texts.get("file.commandCopied", command.get()));
    }

    private void toClipboard(Transferable content, String done) {
        try {
            Toolkit.getDefaultToolkit().getSystemClipboard().setContents(content, null);
            status.report(done);
        } catch (IllegalStateException busy) {
            Messages.error(frame, Texts.get("file.clipboardBusy"));
        }
    }
}
