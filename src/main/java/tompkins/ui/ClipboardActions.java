package tompkins.ui;

import java.awt.Toolkit;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.Transferable;
import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicReference;
import javax.swing.JFrame;
import tompkins.animation.Animation;
import tompkins.image.BufferedImages;
import tompkins.image.LinearImage;
import tompkins.image.PictureLabel;
import tompkins.measure.OverlayKind;
import tompkins.studio.Studio;
import tompkins.ui.file.BackgroundTask;
import tompkins.ui.file.ImageSelection;
import tompkins.ui.model.StudioModel;
import tompkins.ui.picture.Picture;
import tompkins.ui.picture.SceneOverlay;
import tompkins.ui.widget.Messages;
import tompkins.ui.widget.Texts;

/** Copies the photograph, or the command lines that take it or an animation of it, for other programs. */
final class ClipboardActions {

    private final JFrame frame;
    private final StudioModel model;
    private final PhotographView view;
    private final Captions captions;
    private final Signs signs;
    private final CommandLineWriter commandLine;
    private final StatusBar status;

    ClipboardActions(
            JFrame frame,
            StudioModel model,
            PhotographView view,
            Captions captions,
            Signs signs,
            CommandLineWriter commandLine,
            StatusBar status) {
        this.frame = frame;
        this.model = model;
        this.view = view;
        this.captions = captions;
        this.signs = signs;
        this.commandLine = commandLine;
        this.status = status;
    }

    /** Puts the photograph on the clipboard, in its own size, with its overlays and its caption if it has any. */
    void copyPicture() {
        Studio studio = model.studio();
        Picture onScreen = view.canvas().shown().now();
        Set<OverlayKind> overlays = signs.ofScene();
        String caption = captions.shown(studio);
        AtomicReference<BufferedImage> copy = new AtomicReference<>();
        BackgroundTask.start(
                frame,
                Texts.get("file.copying"),
                task -> copy.set(
                        levels(PhotographExport.photograph(studio, onScreen, task), studio, overlays, caption)),
                () -> toClipboard(new ImageSelection(copy.get()), Texts.get("file.pictureCopied")),
                () -> status.report(Texts.get("file.notCopied")));
    }

    private static BufferedImage levels(LinearImage image, Studio studio, Set<OverlayKind> overlays, String caption) {
        BufferedImage levels =
                BufferedImages.toBufferedImage(image, studio.settings().toneCurve());
        SceneOverlay.paint(levels, studio, overlays);
        if (!caption.isEmpty()) {
            PictureLabel.paint(levels, caption);
        }
        return levels;
    }

    /** Puts the command line that takes this photograph on the clipboard. */
    void copyCommandLine() {
        copy(commandLine.photograph(model.studio(), model.opened(), model.file()));
    }

    /** Puts the command line that saves an animation on the clipboard. */
    void copyCommandLine(Animation animation) {
        copy(commandLine.animation(model.studio(), animation, captions.areShown(), model.opened(), model.file()));
    }

    /** Puts what was measured on the clipboard. */
    void copyMeasured(String text) {
        toClipboard(new StringSelection(text), Texts.get("measure.copied"));
    }

    private void copy(Optional<String> command) {
        if (command.isEmpty()) {
            // the clipboard may still hold the command of another photograph
            Messages.error(frame, Texts.get(model.file() == null ? "file.copyNeedsFile" : "file.saveFirst"));
            return;
        }
        toClipboard(new StringSelection(command.get()), Texts.get("file.commandCopied", command.get()));
    }

    /** Says how to cite the program, and puts that on the clipboard if asked to. */
    void offerCitation() {
        String reference = Texts.get("help.reference");
        String entry = Texts.get("help.bibtex");
        int chosen = Messages.tellAndAsk(
                frame,
                Texts.get("menu.cite"),
                Texts.get("help.cite", reference, entry),
                Texts.get("help.copyReference"),
                Texts.get("help.copyBibtex"),
                Texts.get("help.close"));
        if (chosen < 2) {
            toClipboard(new StringSelection(chosen == 0 ? reference : entry), Texts.get("help.citationCopied"));
        }
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
