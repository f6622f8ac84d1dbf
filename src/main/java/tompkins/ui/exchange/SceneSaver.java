package tompkins.ui.exchange;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import tompkins.io.StudioWriter;
import tompkins.studio.Studio;
import tompkins.ui.file.BackgroundTask;
import tompkins.ui.file.FormatFilter;
import tompkins.ui.file.Loss;
import tompkins.ui.file.SaveDialog;
import tompkins.ui.photograph.WindowParts;
import tompkins.ui.widget.EntryField;
import tompkins.ui.widget.Messages;
import tompkins.ui.widget.Texts;

/** Saves scenes, without losing what others wrote in their files. Writes away from the event thread. */
public final class SceneSaver {

    private final WindowParts window;
    private final FileDialogs dialogs;

    /** What the scene files held when they were last opened or saved. */
    private final Map<Path, Studio> held = new HashMap<>();

    /** Saves the scene of a window. */
    public SceneSaver(WindowParts window, FileDialogs dialogs) {
        this.window = window;
        this.dialogs = dialogs;
        hold(window.model().file(), window.model().studio());
    }

    /** Remembers what a file held when it was opened. */
    void hold(Path file, Studio studio) {
        held.put(file, studio);
    }

    /** Saves the scene where it came from; asks for a place if it has none. */
    public void save() {
        save(() -> {});
    }

    /**
     * Saves the scene where it came from; asks for a place if it has none.
     *
     * @param next done after the scene was saved; not done if it was not saved
     */
    public void save(Runnable next) {
        EntryField.takeAll(window.frame());
        if (window.model().file() == null) {
            dialogs.pause();
            saveAs(saving(next));
        } else {
            saveOver(window.model().file(), saving(next));
        }
    }

    /** A scene as it was when it was saved; an animation may go on meanwhile. */
    private record Saving(Studio studio, Studio opened, Runnable next) {}

    private Saving saving(Runnable next) {
        return new Saving(window.model().studio(), window.model().opened(), next);
    }

    /** Saves over a scene file; asks first if that loses what somebody wrote. */
    private void saveOver(Path file, Saving saving) {
        Studio before = held.get(file);
        BackgroundTask.Work<Loss> search = task -> {
            Loss found = Loss.of(file, before);
            task.requireWanted();
            return found;
        };
        // the content of a file that is being saved is not known: it is read as if it were saved
        dialogs.save(file, search, loss -> {
            switch (loss) {
                case NOTHING -> write(file, saving, true);
                case PHOTOGRAPH -> saveAs(saving);
                case HANDWRITING, OTHER_SCENE -> askAboutLoss(loss, file, saving);
            }
        });
    }

    private void askAboutLoss(Loss loss, Path file, Saving saving) {
        int answer = Messages.choose(
                window.frame(),
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
    public void saveAs() {
        EntryField.takeAll(window.frame());
        dialogs.pause();
        saveAs(saving(() -> {}));
    }

    private void saveAs(Saving saving) {
        FormatFilter<String> json = new FormatFilter<>("json", Texts.get("file.sceneFiles"), List.of(".json"));
        SaveDialog.ask(
                window.frame(),
                dialogs.chooser(),
                Texts.get("file.saveScene"),
                dialogs.fileName(),
                List.of(json),
                (file, format, replace) -> write(file, saving, replace));
    }

    private void write(Path file, Saving saving, boolean replace) {
        Studio studio = saving.studio;
        Consumer<Path> done = place -> {
            // another scene may have been opened meanwhile, or this one been saved there before
            if (window.model().opened() == saving.opened
                    || place.equals(window.model().file())) {
                window.model().saved(studio, place);
            }
            held.put(place, studio);
            dialogs.saved(place);
            saving.next.run();
        };
        dialogs.save(file, task -> StudioWriter.save(studio, file, replace), done);
    }
}
