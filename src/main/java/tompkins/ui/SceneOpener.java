package tompkins.ui;

import java.nio.file.Path;
import java.util.Objects;
import javax.swing.JFileChooser;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import javax.swing.filechooser.FileNameExtensionFilter;
import tompkins.experiment.LessonStudio;
import tompkins.io.StudioReader;
import tompkins.studio.Studio;
import tompkins.ui.file.BackgroundTask;
import tompkins.ui.file.ChosenFile;
import tompkins.ui.file.FileDrop;
import tompkins.ui.file.PlainPath;
import tompkins.ui.model.StudioModel;
import tompkins.ui.widget.EntryField;
import tompkins.ui.widget.Messages;
import tompkins.ui.widget.Texts;

/** Opens scenes, without losing what was changed in the one before. Reads away from the event thread. */
final class SceneOpener {

    private final JFrame frame;
    private final StudioModel model;
    private final PhotographView view;
    private final StatusBar status;
    private final Settings settings;
    private final FileDialogs dialogs;
    private final SceneSaver saver;
    private final Runnable pause;
    private final Runnable beginLesson;

    SceneOpener(
            JFrame frame,
            StudioModel model,
            PhotographView view,
            StatusBar status,
            Settings settings,
            FileDialogs dialogs,
            SceneSaver saver,
            Runnable pause,
            Runnable beginLesson) {
        this.frame = frame;
        this.model = model;
        this.view = view;
        this.status = status;
        this.settings = settings;
        this.dialogs = dialogs;
        this.saver = saver;
        this.pause = pause;
        this.beginLesson = beginLesson;
    }

    /**
     * Does something that leaves the scene, after its changes are saved or discarded; does nothing if the user cancels.
     */
    void leaveScene(Runnable next) {
        // otherwise the scene would go on changing behind the question and never be saved
        pause.run();
        EntryField.takeAll(frame);
        Messages.Unsaved answer = model.isModified()
                ? Messages.askAboutChanges(frame, model.studio().title())
                : Messages.Unsaved.DISCARD;
        switch (answer) {
            case SAVE ->
                saver.save(() -> {
                    // changes made while the file was written are not in it
                    if (!model.isModified()) {
                        next.run();
                    }
                });
            case DISCARD -> next.run();
            case CANCEL -> {}
        }
    }

    /** Asks for a file and opens it. */
    void open() {
        leaveForAnother(this::choose);
    }

    private void choose() {
        JFileChooser chooser = dialogs.chooser();
        chooser.setFileFilter(
                new FileNameExtensionFilter(Texts.get("file.scenes"), "json", "png", "tif", "tiff", "hdr", "pic"));
        if (chooser.showOpenDialog(frame) == JFileChooser.APPROVE_OPTION) {
            ChosenFile.path(frame, chooser.getSelectedFile()).ifPresent(this::read);
        }
    }

    /** Opens a scene file, or a photograph that holds its scene. */
    void open(Path file) {
        leaveForAnother(() -> read(file));
    }

    /**
     * As {@link #leaveScene}, but without a question for an example of which only the camera or the motion was changed:
     * undo brings it back.
     */
    private void leaveForAnother(Runnable next) {
        Studio opened = model.opened();
        Studio now = LessonStudio.unmoved(model.studio(), opened);
        boolean looked = model.file() == null
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
    void begin(Runnable next) {
        leaveForAnother(() -> {
            show(Studio.DEFAULT, null);
            next.run();
        });
    }

    /** Opens the file of the scene again, which another program may have changed. */
    void reload() {
        Path file = model.file();
        if (file == null) {
            status.report(Texts.get("file.noFile"));
        } else {
            open(file);
        }
    }

    private void read(Path named) {
        Path file = PlainPath.of(named);
        BackgroundTask.find(frame, Texts.get("file.opening", file), () -> StudioReader.read(file), studio -> {
            show(studio, file);
            settings.addRecentFile(file);
        });
    }

    /** Shows an example. */
    void open(Studio example) {
        leaveForAnother(() -> show(example, null));
    }

    /** Shows a scene; messages, refused values and the pin of the one before it go. */
    private void show(Studio studio, Path file) {
        status.clear();
        if (!Objects.equals(file, model.file())) {
            dialogs.forgetFolder();
        }
        view.setPin(null);
        view.canvas().zoom().fit();
        model.open(studio, file);
        beginLesson.run();
        saver.hold(file, studio);
        EntryField.in(frame).forEach(EntryField::revert);
    }

    /** Whether files can be dropped on the window, and what becomes of them. */
    FileDrop drop() {
        return new FileDrop(file ->
                SwingUtilities.invokeLater(() -> ChosenFile.path(frame, file).ifPresent(this::open)));
    }
}
