package tompkins.ui.exchange;

import java.nio.file.Path;
import javax.swing.JFileChooser;
import javax.swing.SwingUtilities;
import javax.swing.filechooser.FileNameExtensionFilter;
import tompkins.io.StudioReader;
import tompkins.studio.Studio;
import tompkins.ui.file.BackgroundTask;
import tompkins.ui.file.ChosenFile;
import tompkins.ui.file.FileDrop;
import tompkins.ui.photograph.WindowParts;
import tompkins.ui.widget.EntryField;
import tompkins.ui.widget.Messages;
import tompkins.ui.widget.Texts;

/** Opens scenes, without losing what was changed in the one before. Reads away from the event thread. */
public final class SceneOpener {

    private final WindowParts window;
    private final FileDialogs dialogs;
    private final SceneSaver saver;

    /** Opens scenes in a window. */
    public SceneOpener(WindowParts window, FileDialogs dialogs, SceneSaver saver) {
        this.window = window;
        this.dialogs = dialogs;
        this.saver = saver;
    }

    /**
     * Does something that leaves the scene, after its changes are saved or discarded; does nothing if the user cancels.
     */
    public void leaveScene(Runnable next) {
        // otherwise the scene would go on changing behind the question and never be saved
        dialogs.pause();
        EntryField.takeAll(window.frame());
        Messages.Unsaved answer = window.model().isEdited()
                ? Messages.askAboutChanges(
                        window.frame(), window.model().studio().title())
                : Messages.Unsaved.DISCARD;
        switch (answer) {
            case SAVE ->
                saver.save(() -> {
                    // changes made while the file was written are not in it
                    if (!window.model().isModified()) {
                        next.run();
                    }
                });
            case DISCARD -> next.run();
            case CANCEL -> {}
        }
    }

    /** Asks for a file and opens it. */
    public void open() {
        leaveForAnother(this::choose);
    }

    private void choose() {
        JFileChooser chooser = dialogs.chooser();
        chooser.setFileFilter(
                new FileNameExtensionFilter(Texts.get("file.scenes"), "json", "png", "tif", "tiff", "hdr", "pic"));
        if (chooser.showOpenDialog(window.frame()) == JFileChooser.APPROVE_OPTION) {
            ChosenFile.path(window.frame(), chooser.getSelectedFile()).ifPresent(this::read);
        }
    }

    /** Opens a scene file, or a photograph that holds its scene. */
    public void open(Path file) {
        leaveForAnother(() -> read(file));
    }

    /**
     * As {@link #leaveScene}, but without a question where only the slider of a lesson was moved, or the camera or the
     * motion of an example: undo brings it back.
     */
    private void leaveForAnother(Runnable next) {
        Studio opened = window.model().opened();
        Studio now = window.model().unmoved();
        boolean looked = now.equals(opened)
                || window.model().file() == null
                        && now.hasSameObjects(opened)
                        && (now.ride().isEmpty() || now.ride().equals(opened.ride()))
                        && now.lesson().equals(opened.lesson())
                        && now.title().equals(opened.title())
                        && now.remarks().equals(opened.remarks());
        if (looked) {
            next.run();
        } else {
            leaveScene(next);
        }
    }

    /** Begins a scene without objects, and then does something else, such as opening the editor. */
    public void begin(Runnable next) {
        leaveForAnother(() -> {
            show(Studio.DEFAULT, null);
            next.run();
        });
    }

    /** Opens the file of the scene again, which another program may have changed; an example as it was opened. */
    public void reload() {
        Path file = window.model().file();
        if (file == null) {
            open(window.model().opened());
        } else {
            open(file);
        }
    }

    private void read(Path named) {
        Path file = ChosenFile.plain(named);
        BackgroundTask.find(window.frame(), Texts.get("file.opening", file), () -> StudioReader.read(file), studio -> {
            show(studio, file);
            window.settings().addRecentFile(file);
            dialogs.used(file);
        });
    }

    /** Shows an example. */
    public void open(Studio example) {
        leaveForAnother(() -> show(example, null));
    }

    /** Shows a scene; refused values of the one before it go, and each part of the window forgets what it has of it. */
    private void show(Studio studio, Path file) {
        window.model().open(studio, file);
        saver.hold(file, studio);
        EntryField.in(window.frame()).forEach(EntryField::revert);
    }

    /** Opens the first of the files that are dropped on the window. */
    public FileDrop drop() {
        // the program from which they come waits for the end of the drop, and not for questions
        return new FileDrop(files -> SwingUtilities.invokeLater(
                () -> ChosenFile.path(window.frame(), files.get(0)).ifPresent(this::open)));
    }
}
