package tompkins.ui.exchange;

import java.io.File;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.JFileChooser;
import tompkins.ui.editor.FileContentEditor;
import tompkins.ui.file.BackgroundTask;
import tompkins.ui.photograph.WindowParts;
import tompkins.ui.widget.EntryField;
import tompkins.ui.widget.Texts;

/** What the window asks and says about files: which one to read or write, and what became of it. */
public final class FileDialogs implements FileContentEditor.Choosers {

    private final WindowParts window;
    private final Runnable pause;

    /** The folder where a file was last read or saved; null before. */
    private File lastFolder;

    /** The dialogs of a window; {@code pause} pauses what moves there by itself. */
    public FileDialogs(WindowParts window, Runnable pause) {
        this.window = window;
        this.pause = pause;
    }

    /** Pauses what moves by itself, before something is asked about the scene. */
    void pause() {
        pause.run();
    }

    /**
     * A file chooser, behind which nothing moves. It starts where a file was last read or saved, else in the folder of
     * the scene, else where any file was last opened or saved.
     */
    @Override
    public JFileChooser chooser() {
        pause();
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
        return Stream.concat(Stream.ofNullable(window.model().file()), window.settings().recentFiles().stream())
                .map(file -> file.toAbsolutePath().getParent().toFile())
                .findFirst()
                .orElse(null);
    }

    /** The name for files of the scene, without an ending: that of its own file, or its title up to a colon. */
    public String fileName() {
        String name = window.model().file() == null
                ? window.model()
                        .studio()
                        .shortTitle()
                        .replaceAll("[^\\p{L}\\p{N}]+", "-")
                        .replaceAll("^-|-$", "")
                : window.model().file().getFileName().toString().replaceAll("(?<=.)\\.[^.]*$", "");
        return name.isEmpty() ? "scene" : name;
    }

    /**
     * Saves a file in the background, unless that is being saved already.
     *
     * @param done takes what came of it when it was saved
     */
    public <T> void save(Path file, BackgroundTask.Work<T> work, Consumer<? super T> done) {
        if (BackgroundTask.isWriting(file)) {
            window.status().report(Texts.get("file.stillSaving", file));
        } else {
            BackgroundTask.start(
                    window.frame(),
                    Texts.get("file.saving", file),
                    file,
                    work,
                    done,
                    () -> window.status().report(Texts.get("file.notSaved", file)));
        }
    }

    /** Says that a file was saved that can be opened again. */
    void saved(Path file) {
        window.settings().addRecentFile(file);
        used(file);
        boolean refused = EntryField.in(window.frame()).anyMatch(EntryField::isPending);
        window.status().report(Texts.get(refused ? "file.savedWithout" : "file.saved", file));
    }

    /** Says that a file was saved that cannot be opened again, and what the user should know about it. */
    public void exported(Path file, List<String> warnings) {
        used(file);
        String saved = Texts.get("file.saved", file);
        // it may have taken so long that the user is not looking
        window.status().say(Stream.concat(Stream.of(saved), warnings.stream()).collect(Collectors.joining("; ")));
    }
}
