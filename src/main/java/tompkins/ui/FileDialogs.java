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

/** What the window asks about files and says of them: which one to read or write, and what became of it. */
final class FileDialogs implements FileContentEditor.Choosers {

    private final JFrame frame;
    private final StudioModel model;
    private final StatusBar status;
    private final Settings settings;

    /** Where a file was read or saved last, as long as the scene has the same file; null before. */
    private File lastFolder;

    FileDialogs(JFrame frame, StudioModel model, StatusBar status, Settings settings) {
        this.frame = frame;
        this.model = model;
        this.status = status;
        this.settings = settings;
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

    /** A scene of another file is about to be shown, whose files are elsewhere. */
    void forgetFolder() {
        lastFolder = null;
    }

    /** What files of the scene are called, without an ending: like its own, or like its title up to a colon. */
    String fileName() {
        String name = model.file() == null
                ? model.studio()
                        .shortTitle()
                        .replaceAll("[^\\p{L}\\p{N}]+", "-")
                        .replaceAll("^-|-$", "")
                : model.file().getFileName().toString().replaceAll("(?<=.)\\.[^.]*$", "");
        return name.isEmpty() ? "scene" : name;
    }

    /** A file was saved that can be opened again; tells of it. */
    void saved(Path file) {
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

    /** Tells that a file was left as it was, since its saving was cancelled. */
    void sayNotSaved(Path file) {
        status.report(Texts.get("file.notSaved", file));
    }
}
