package tompkins.ui;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Stream;
import javax.swing.JFrame;
import tompkins.image.FileException;
import tompkins.image.LinearImage;
import tompkins.image.PhotographFile;
import tompkins.image.PhotographInfo;
import tompkins.image.PictureFormat;
import tompkins.image.ToneCurve;
import tompkins.io.SelfDescription;
import tompkins.io.StudioWriter;
import tompkins.render.PhotographTaker;
import tompkins.render.Progress;
import tompkins.studio.Studio;
import tompkins.ui.file.BackgroundTask;
import tompkins.ui.file.FormatFilter;
import tompkins.ui.file.SaveDialog;
import tompkins.ui.model.StudioModel;
import tompkins.ui.picture.Picture;
import tompkins.ui.widget.EntryField;
import tompkins.ui.widget.Texts;

/** Saves photographs, with their scenes inside. Takes and writes them away from the event thread. */
final class PhotographExport {

    private final JFrame frame;
    private final StudioModel model;
    private final PhotographView view;
    private final StatusBar status;
    private final FileDialogs dialogs;

    PhotographExport(JFrame frame, StudioModel model, PhotographView view, StatusBar status, FileDialogs dialogs) {
        this.frame = frame;
        this.model = model;
        this.view = view;
        this.status = status;
        this.dialogs = dialogs;
    }

    /** Asks where to save the photograph. */
    void ask() {
        EntryField.takeAll(frame);
        Studio studio = model.studio();
        List<FormatFilter<PictureFormat>> formats = Stream.of(PictureFormat.values())
                .map(format -> new FormatFilter<>(format, Texts.get("format." + format), format.endings()))
                .toList();
        SaveDialog.ask(
                frame,
                dialogs.chooser(),
                Texts.get(
                        "file.savePhotograph",
                        studio.settings().width(),
                        studio.settings().height()),
                dialogs.fileName(),
                formats,
                (file, format, replace) -> save(studio, file, format, replace));
    }

    /** Saves the complete photograph of a studio, with the scene inside. */
    private void save(Studio studio, Path file, PictureFormat format, boolean replace) {
        AtomicReference<Path> saved = new AtomicReference<>();
        Picture onScreen = view.canvas().shown().now();
        BackgroundTask.start(
                frame,
                Texts.get("file.saving", file),
                task -> {
                    PhotographInfo info = SelfDescription.of(studio);
                    LinearImage image = photograph(studio, onScreen, task);
                    saved.set(write(file, image, format, studio.settings().toneCurve(), info, replace));
                },
                () -> {
                    Path place = saved.get();
                    dialogs.saved(place);
                    List<String> named = StudioWriter.filesOnlyNamed(studio);
                    if (!named.isEmpty()) {
                        // it asks for something
                        status.say(Texts.get("file.savedNaming", place, String.join(", ", named)));
                    }
                },
                () -> dialogs.sayNotSaved(file));
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

    /** Saves a picture and returns where it lies. */
    private static Path write(
            Path file, LinearImage image, PictureFormat format, ToneCurve curve, PhotographInfo info, boolean replace)
            throws FileException {
        if (!replace) {
            return PhotographFile.writeNew(file, image, format, curve, info);
        }
        PhotographFile.write(file, image, format, curve, info);
        return file;
    }
}
