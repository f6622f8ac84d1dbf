package tompkins.ui;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicReference;
import javax.swing.JFrame;
import tompkins.io.StudioWriter;
import tompkins.studio.Studio;
import tompkins.ui.file.BackgroundTask;
import tompkins.ui.file.FormatFilter;
import tompkins.ui.file.Loss;
import tompkins.ui.file.SaveDialog;
import tompkins.ui.model.StudioModel;
import tompkins.ui.widget.EntryField;
import tompkins.ui.widget.Messages;
import tompkins.ui.widget.Texts;

/** Saves scenes, without losing what others wrote in their files. Writes away from the event thread. */
final class SceneSaver {

    private final JFrame frame;
    private final StudioModel model;
    private final StatusBar status;
    private final FileDialogs dialogs;

    /** What the scene files held when they were last opened or saved. */
    private final Map<Path, Studio> held = new HashMap<>();

    /** The last attempt to save a scene in a file, which may still go on. */
    private final Map<Path, BackgroundTask> saves = new HashMap<>();

    SceneSaver(JFrame frame, StudioModel model, StatusBar status, FileDialogs dialogs) {
        this.frame = frame;
        this.model = model;
        this.status = status;
        this.dialogs = dialogs;
        hold(model.file(), model.studio());
    }

    /** Remembers what a file held when it was opened. */
    void hold(Path file, Studio studio) {
        held.put(file, studio);
    }

    /** Saves the scene where it came from; asks for a place if it has none. */
    void save() {
        save(() -> {});
    }

    /**
     * Saves the scene where it came from; asks for a place if it has none.
     *
     * @param next done after the scene was saved; not done if it was not saved
     */
    void save(Runnable next) {
        EntryField.takeAll(frame);
        Saving saving = new Saving(model.studio(), model.opened(), next);
        if (model.file() == null) {
            saveAs(saving);
        } else {
            saveOver(model.file(), saving);
        }
    }

    /** A scene as it was when it was saved; an animation may go on behind the questions. */
    private record Saving(Studio studio, Studio opened, Runnable next) {}

    /** Saves over a scene file; asks first if that loses what somebody wrote. */
    private void saveOver(Path file, Saving saving) {
        if (isBeingSaved(file)) {
            return;
        }
        Studio before = held.get(file);
        BackgroundTask search =
                BackgroundTask.find(frame, Texts.get("file.saving", file), () -> Loss.of(file, before), loss -> {
                    switch (loss) {
                        case NOTHING -> write(file, saving, true);
                        case PHOTOGRAPH -> saveAs(saving);
                        case HANDWRITING, OTHER_SCENE -> askAboutLoss(loss, file, saving);
                    }
                });
        awaitEnd(file, search);
    }

    /** Waits with saving in a file until the last attempt to save there has ended. */
    void awaitEnd(Path file, BackgroundTask save) {
        saves.put(file, save);
    }

    /**
     * Whether a file is being saved, and if so tells the user: its content is not known, and a second writer might be
     * faster.
     */
    private boolean isBeingSaved(Path file) {
        BackgroundTask last = saves.get(file);
        boolean saving = last != null && last.isRunning();
        if (saving) {
            status.report(Texts.get("file.stillSaving", file));
        }
        return saving;
    }

    private void askAboutLoss(Loss loss, Path file, Saving saving) {
        int answer = Messages.choose(
                frame,
                Texts.get("file.overwriteTitle"),
                Texts.get("loss." + loss, file.getFileName()),
                Texts.get("menu.saveSceneAs"),
                Texts.get("file.saveAnyway"),
                Texts.get("task.cancel"));
        switch (answer) {
            case 0 -> saveAs(saving);
            case 1 -> write(file, saving, true);
            default -> {}
        }
    }

    /** Asks where to save the scene. */
    void saveAs() {
        EntryField.takeAll(frame);
        saveAs(new Saving(model.studio(), model.opened(), () -> {}));
    }

    private void saveAs(Saving saving) {
        FormatFilter<String> json = new FormatFilter<>("json", Texts.get("file.sceneFiles"), List.of(".json"));
        SaveDialog.ask(
                frame,
                dialogs.chooser(),
                Texts.get("file.saveScene"),
                dialogs.fileName(),
                List.of(json),
                (file, format, replace) -> write(file, saving, replace));
    }

    private void write(Path file, Saving saving, boolean replace) {
        if (isBeingSaved(file)) {
            return;
        }
        Studio studio = saving.studio;
        AtomicReference<Path> saved = new AtomicReference<>();
        Runnable done = () -> {
            Path place = saved.get();
            // another scene may have been opened meanwhile
            if (model.opened() == saving.opened) {
                model.saved(studio, place);
            }
            held.put(place, studio);
            dialogs.saved(place);
            saving.next.run();
        };
        awaitEnd(
                file,
                BackgroundTask.start(
                        frame,
                        Texts.get("file.saving", file),
                        task -> saved.set(write(studio, file, replace)),
                        done,
                        () -> dialogs.sayNotSaved(file)));
    }

    /** Saves a scene and returns where it lies. */
    private static Path write(Studio studio, Path file, boolean replace) throws IOException {
        if (!replace) {
            return StudioWriter.saveNew(studio, file);
        }
        StudioWriter.save(studio, file);
        return file;
    }
}
