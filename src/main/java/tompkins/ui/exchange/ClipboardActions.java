package tompkins.ui.exchange;

import java.awt.Toolkit;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.Transferable;
import java.awt.image.BufferedImage;
import java.util.Set;
import tompkins.image.BufferedImages;
import tompkins.image.LinearImage;
import tompkins.image.PictureLabel;
import tompkins.io.SelfDescription;
import tompkins.measure.OverlayKind;
import tompkins.studio.Studio;
import tompkins.ui.file.BackgroundTask;
import tompkins.ui.file.ImageSelection;
import tompkins.ui.overlay.PictureOverlays;
import tompkins.ui.overlay.SceneOverlay;
import tompkins.ui.photograph.Captions;
import tompkins.ui.photograph.WindowParts;
import tompkins.ui.picture.Picture;
import tompkins.ui.widget.Messages;
import tompkins.ui.widget.Texts;

/** Copies the photograph, what was measured in it, and how to cite the program. */
public final class ClipboardActions {

    private final WindowParts window;
    private final Captions captions;
    private final PictureOverlays overlays;

    /** The clipboard of a window. */
    public ClipboardActions(WindowParts window, Captions captions, PictureOverlays overlays) {
        this.window = window;
        this.captions = captions;
        this.overlays = overlays;
    }

    /** Puts the photograph on the clipboard, in its own size, with its overlays and its caption if it has any. */
    public void copyPicture() {
        Studio studio = window.model().studio();
        Picture onScreen = window.view().canvas().shown().now();
        Set<OverlayKind> drawn = overlays.ofScene();
        String caption = captions.shown(studio);
        BackgroundTask.start(
                window.frame(),
                Texts.get("file.copying"),
                null,
                task -> levels(PhotographExport.photograph(studio, onScreen, task), studio, drawn, caption),
                copy -> toClipboard(new ImageSelection(copy), Texts.get("file.pictureCopied")),
                () -> window.status().report(Texts.get("file.notCopied")));
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

    /** Puts what was measured on the clipboard. */
    public void copyMeasured(String text) {
        toClipboard(new StringSelection(text), Texts.get("measure.copied"));
    }

    /** Says how to cite the program, and puts that on the clipboard if asked to. */
    public void offerCitation() {
        String reference = Texts.get("help.reference", SelfDescription.version());
        String entry = Texts.get("help.bibtex", SelfDescription.version());
        int chosen = Messages.tellAndAsk(
                window.frame(),
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
            window.status().report(done);
        } catch (IllegalStateException busy) {
            Messages.error(window.frame(), Texts.get("file.clipboardBusy"));
        }
    }
}
