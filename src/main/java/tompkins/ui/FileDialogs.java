package tompkins.ui;

import java.io.File;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.JFileChooser;
import javax.swing.JFrame;
import tompkins.ui.editor.FileContentEditor;
import tompkins.ui.model.StudioModel;
import tompkins.ui.widget.EntryField;
import tompkins.ui.widget.Texts;

/** What the window asks and says about files: which one to read or write, and what became of it. */
final class FileDialogs implements FileContentEditor.Choosers {

    private final JFrame frame;
    private final StudioModel model;
    private final StatusBar status;
    private final Settings settings;

    /** The folder where a file was last read or saved while the scene has the same file; null before. */
    private File lastFolder;

    FileDialogs(JFrame frame, StudioModel model, StatusBar status, Settings settings) {
        this.frame = frame;
        this.model = model;
        this.status = status;
        this.settings = settings;
    }

    /**
     * A file chooser. It starts where a file was last read or saved for this scene, else in the folder of the scene,
     * else where any file was last opened or saved.
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

    /** Tells that a scene from another file is about to be shown, whose files are elsewhere. */
    void forgetFolder() {
        lastFolder = null;
    }

    /** The name for files of the scene, without an ending: that of its own file, or its title up to a colon. */
    String fileName() {
        String name = model.file() == null
                ? model.studio()
                        .shortTitle()
                        .replaceAll("[^\\p{L}\\p{N}]+", "-")
                        .replaceAll("^-|-$", "")
                : model.file().getFileName().toString().replaceAll("(?<=.)\\.[^.]*$", "");
        return name.isEmpty() ? "scene" : name;
    }

    /** Says that a file was saved that can be opened again. */
    void saved(Path file) {
        settings.addRecentFile(file);
        used(file);
        boolean refused = EntryField.in(frame).anyMatch(EntryField::isPending);
        status.report(Texts.get(refused ? "file.savedWithout" : "file.saved", file));
    }

    /** Says that a file was saved that cannot be opened again, and what the user should know about it. */
    void exported(Path file, List<String> warnings) {
        used(file);
        String saved = Texts.get("file.saved", file);
        // it may have taken so long that the user is not looking
        status.say(Stream.concat(Stream.of(saved), warnings.stream()).collect(Collectors.joining("; ")));
    }

    /** Says that a file was left as it was because saving was cancelled. */
    void sayNotSaved(Path file) {
        status.report(Texts.get("file.notSaved", file));
    }
}
