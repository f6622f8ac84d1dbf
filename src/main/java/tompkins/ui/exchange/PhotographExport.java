package tompkins.ui.exchange;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JFileChooser;
import tompkins.image.LinearImage;
import tompkins.image.PhotographFile;
import tompkins.image.PhotographInfo;
import tompkins.image.PictureFormat;
import tompkins.io.SelfDescription;
import tompkins.io.StudioWriter;
import tompkins.render.PhotographTaker;
import tompkins.render.Progress;
import tompkins.studio.Studio;
import tompkins.ui.file.FormatFilter;
import tompkins.ui.file.SaveDialog;
import tompkins.ui.photograph.WindowParts;
import tompkins.ui.picture.Picture;
import tompkins.ui.widget.EntryField;
import tompkins.ui.widget.Texts;

/** Saves photographs, with their scenes inside. Takes and writes them away from the event thread. */
public final class PhotographExport {

    private final WindowParts window;
    private final FileDialogs dialogs;

    /** Saves the photograph of a window. */
    public PhotographExport(WindowParts window, FileDialogs dialogs) {
        this.window = window;
        this.dialogs = dialogs;
    }

    /** Asks where to save the photograph. */
    public void ask() {
        EntryField.takeAll(window.frame());
        // before a ride pauses: a recording goes back to its beginning then
        Studio studio = window.model().studio();
        List<FormatFilter<PictureFormat>> formats = Stream.of(PictureFormat.values())
                .map(format -> new FormatFilter<>(format, Texts.get("format." + format), format.endings()))
                .toList();
        PhotographOptions options = new PhotographOptions(studio);
        JFileChooser chooser = dialogs.chooser();
        chooser.setAccessory(options.component());
        SaveDialog.ask(
                window.frame(),
                chooser,
                Texts.get("file.savePhotograph"),
                dialogs.fileName(),
                formats,
                (file, format, replace) -> save(options.studio(), file, format, replace));
    }

    /** Saves the complete photograph of a studio, with the scene inside. */
    private void save(Studio studio, Path file, PictureFormat format, boolean replace) {
        Picture onScreen = window.view().canvas().shown().now();
        dialogs.save(
                file,
                task -> {
                    PhotographInfo info = SelfDescription.of(studio);
                    LinearImage image = photograph(studio, onScreen, task);
                    return PhotographFile.write(
                            file, image, format, studio.settings().toneCurve(), info, replace);
                },
                place -> {
                    dialogs.saved(place);
                    List<String> named = StudioWriter.filesOnlyNamed(studio);
                    if (!named.isEmpty()) {
                        // it asks for something
                        window.status().say(Texts.get("file.savedNaming", place, String.join(", ", named)));
                    }
                });
    }

    /**
     * The photograph of a studio in its own size: the picture on the screen if it has that size, otherwise a new one.
     */
    static LinearImage photograph(Studio studio, Picture onScreen, Progress progress) throws InterruptedException {
        if (onScreen != null
                && onScreen.complete()
                && onScreen.isOfOwnSize()
                && onScreen.studio().equals(studio)) {
            return onScreen.image();
        }
        try (PhotographTaker taker = new PhotographTaker()) {
            return taker.take(studio, progress, 0, 1).image();
        }
    }
}
