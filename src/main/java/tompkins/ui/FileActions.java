package tompkins.ui;

import java.io.File;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.JFileChooser;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import javax.swing.filechooser.FileNameExtensionFilter;
import tompkins.image.LinearImage;
import tompkins.image.PhotographFile;
import tompkins.image.PhotographInfo;
import tompkins.image.PictureFormat;
import tompkins.io.SelfDescription;
import tompkins.io.StudioReader;
import tompkins.io.StudioWriter;
import tompkins.render.PhotographTaker;
import tompkins.studio.Studio;
import tompkins.ui.editor.FileContentEditor;
import tompkins.ui.file.BackgroundTask;
import tompkins.ui.file.ChosenFile;
import tompkins.ui.file.FileDrop;
import tompkins.ui.file.FormatFilter;
import tompkins.ui.file.Loss;
import tompkins.ui.file.PlainPath;
import tompkins.ui.file.SaveDialog;
import tompkins.ui.model.StudioModel;
import tompkins.ui.picture.Picture;
import tompkins.ui.widget.EntryField;
import tompkins.ui.widget.Messages;
import tompkins.ui.widget.Texts;

/** Opens and saves scenes, saves photographs. All are read and written away from the event thread. */
final class FileActions implements FileContentEditor.Choosers {

    private final JFrame frame;
    private final StudioModel model;
    private final PhotographView view;
    private final Settings settings;
    private final Runnable pause;
    private final StatusBar status;

    /** What the scene files held when they were opened or saved last. */
    private final Map<Path, Studio> held = new HashMap<>();

    /** What was done last to save a scene in a file; it may still go on. */
    private final Map<Path, BackgroundTask> saves = new HashMap<>();

    /** Where a file was read or saved last, as long as the scene has the same file; null before. */
    private File lastFolder;

    FileActions(
            JFrame frame, StudioModel model, PhotographView view, StatusBar status, Settings settings, Runnable pause) {
        this.frame = frame;
        this.model = model;
        this.view = view;
        this.status = status;
        this.settings = settings;
        this.pause = pause;
        held.put(model.file(), model.studio());
    }

    /** Does what lets go of the scene, once its changes are saved or discarded; not at all if the user cancels that. */
    void leaveScene(Runnable next) {
        // or the scene would go on changing behind the question, and never be saved
        pause.run();
        takeEntries();
        Messages.Unsaved answer = model.isModified()
                ? Messages.askAboutChanges(frame, model.studio().title())
                : Messages.Unsaved.DISCARD;
        switch (answer) {
            case SAVE ->
                saveScene(() -> {
                    // what changed while the file was written is not in it
                    if (!model.isModified()) {
                        next.run();
                    }
                });
            case DISCARD -> next.run();
            case CANCEL -> {}
        }
    }

    /**
     * Takes what was typed without Enter, so that it is not missing from what is saved; what is refused stays where it
     * is.
     */
    private void takeEntries() {
        EntryField.takeAll(frame);
    }

    /** Asks for a file and opens it. */
    void open() {
        leaveForAnother(this::choose);
    }

    private void choose() {
        JFileChooser chooser = chooser();
        chooser.setFileFilter(
                new FileNameExtensionFilter(Texts.get("file.scenes"), "json", "png", "tif", "tiff", "hdr", "pic"));
        if (chooser.showOpenDialog(frame) == JFileChooser.APPROVE_OPTION) {
            ChosenFile.path(frame, chooser.getSelectedFile()).ifPresent(this::read);
        }
    }

    /**
     * A file chooser where a file was read or saved last for this scene; before, in the folder of the scene, or,
     * without one, where a file was opened or saved last.
     */
    @Override
    public JFileChooser chooser() {
        File folder = lastFolder == null ? folderOfTheScene() : lastFolder;
        JFileChooser chooser = new JFileChooser(folder);
        chooser.setName("chooser");
        return chooser;
    }

    @Override
    public void used(Path file) {
        lastFolder = file.toAbsolutePath().getParent().toFile();
    }

    private File folderOfTheScene() {
        return Stream.concat(Stream.ofNullable(model.file()), settings.recentFiles().stream())
                .map(file -> file.toAbsolutePath().getParent().toFile())
                .findFirst()
                .orElse(null);
    }

    /** Opens a scene file, or a photograph that holds its scene. */
    void open(Path file) {
        leaveForAnother(() -> read(file));
    }

    /**
     * An example that was only looked at from elsewhere or in other motion comes back by undo: nothing to ask about.
     */
    private void leaveForAnother(Runnable next) {
        Studio opened = model.opened();
        boolean looked = model.file() == null
                && model.studio().hasSameObjects(opened)
                && model.studio().title().equals(opened.title())
                && model.studio().remarks().equals(opened.remarks());
        if (looked) {
            next.run();
        } else {
            leaveScene(next);
        }
    }

    /** Begins a scene without objects, and then goes on to where they are added. */
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
        lastFolder = Objects.equals(file, model.file()) ? lastFolder : null;
        view.setPin(null);
        model.open(studio, file);
        held.put(file, studio);
        EntryField.in(frame).forEach(EntryField::revert);
    }

    /** Saves the scene where it came from; asks for a place if it has none. */
    void saveScene() {
        takeEntries();
        saveScene(() -> {});
    }

    private void saveScene(Runnable next) {
        Saving saving = new Saving(model.studio(), model.opened(), next);
        if (model.file() == null) {
            saveSceneAs(saving);
        } else {
            saveOver(model.file(), saving);
        }
    }

    /** A scene as it was when it was to be saved: it may play on behind the questions. */
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
                        case NOTHING -> saveScene(file, saving);
                        case PHOTOGRAPH -> saveSceneAs(saving);
                        case HANDWRITING, OTHER_SCENE -> askAboutLoss(loss, file, saving);
                    }
                });
        awaitEnd(file, search);
    }

    /** Does not save a scene in a file again until what was done last to save one there has ended. */
    void awaitEnd(Path file, BackgroundTask save) {
        saves.put(file, save);
    }

    /** Whether a file is being saved, which is said: its content is not known, and another writer might be faster. */
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
            case 0 -> saveSceneAs(saving);
            case 1 -> saveScene(file, saving);
            default -> {}
        }
    }

    /** Asks where to save the scene. */
    void saveSceneAs() {
        takeEntries();
        saveSceneAs(new Saving(model.studio(), model.opened(), () -> {}));
    }

    private void saveSceneAs(Saving saving) {
        FormatFilter<String> json = new FormatFilter<>("json", Texts.get("file.sceneFiles"), List.of(".json"));
        SaveDialog.ask(
                frame,
                chooser(),
                Texts.get("file.saveScene"),
                fileName(),
                List.of(json),
                (file, format) -> saveScene(file, saving));
    }

    private void saveScene(Path file, Saving saving) {
        if (isBeingSaved(file)) {
            return;
        }
        Studio studio = saving.studio;
        Runnable done = () -> {
            // another scene may have been opened meanwhile
            if (model.opened() == saving.opened) {
                model.saved(studio, file);
            }
            held.put(file, studio);
            saved(file);
            saving.next.run();
        };
        awaitEnd(
                file,
                BackgroundTask.start(
                        frame,
                        Texts.get("file.saving", file),
                        task -> StudioWriter.save(studio, file),
                        done,
                        () -> sayNotSaved(file)));
    }

    private void saved(Path file) {
        settings.addRecentFile(file);
        used(file);
        boolean refused = EntryField.in(frame).anyMatch(EntryField::isPending);
        status.report(Texts.get(refused ? "file.savedWithout" : "file.saved", file));
    }

    /** A file was saved that cannot be opened again; tells of it, and what the user should know about it. */
    void exported(Path file, List<String> warnings) {
        used(file);
        String saved = Texts.get("file.saved", file);
        // it may have taken so long that nobody looks
        status.say(Stream.concat(Stream.of(saved), warnings.stream()).collect(Collectors.joining("; ")));
    }

    /** Asks where to save the photograph. */
    void savePhotograph() {
        takeEntries();
        Studio studio = model.studio();
        List<FormatFilter<PictureFormat>> formats = Stream.of(PictureFormat.values())
                .map(format -> new FormatFilter<>(format, Texts.get("format." + format), format.endings()))
                .toList();
        SaveDialog.ask(
                frame,
                chooser(),
                Texts.get(
                        "file.savePhotograph",
                        studio.settings().width(),
                        studio.settings().height()),
                fileName(),
                formats,
                (file, format) -> savePhotograph(studio, file, format));
    }

    /** What files of the scene are called, without an ending: like its own, or like its title up to a colon. */
    private String fileName() {
        String name = model.file() == null
                ? model.studio()
                        .shortTitle()
                        .replaceAll("[^\\p{L}\\p{N}]+", "-")
                        .replaceAll("^-|-$", "")
                : model.file().getFileName().toString().replaceAll("(?<=.)\\.[^.]*$", "");
        return name.isEmpty() ? "scene" : name;
    }

    /** Saves the complete photograph of a studio, with the scene inside. */
    private void savePhotograph(Studio studio, Path file, PictureFormat format) {
        Picture onScreen = view.canvas().shown().now();
        boolean ready =
                onScreen != null && onScreen.complete() && onScreen.studio().equals(studio);
        BackgroundTask.start(
                frame,
                Texts.get("file.saving", file),
                task -> {
                    PhotographInfo info = SelfDescription.of(studio);
                    try (PhotographTaker taker = new PhotographTaker()) {
                        LinearImage image = ready
                                ? onScreen.image()
                                : taker.take(studio, task, 0, 1).image();
                        PhotographFile.write(
                                file, image, format, studio.settings().toneCurve(), info);
                    }
                },
                () -> {
                    saved(file);
                    List<String> named = StudioWriter.filesOnlyNamed(studio);
                    if (!named.isEmpty()) {
                        // it asks for something
                        status.say(Texts.get("file.savedNaming", file, String.join(", ", named)));
                    }
                },
                () -> sayNotSaved(file));
    }

    /** Tells that a file was left as it was, since its saving was cancelled. */
    void sayNotSaved(Path file) {
        status.report(Texts.get("file.notSaved", file));
    }

    /** Whether files can be dropped on the window, and what becomes of them. */
    FileDrop drop() {
        return new FileDrop(file ->
                SwingUtilities.invokeLater(() -> ChosenFile.path(frame, file).ifPresent(this::open)));
    }
}
