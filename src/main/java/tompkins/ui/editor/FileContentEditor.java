package tompkins.ui.editor;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JFileChooser;
import javax.swing.SwingUtilities;
import tompkins.image.PictureFile;
import tompkins.io.MeshFile;
import tompkins.ray.MeshData;
import tompkins.ray.PixelPicture;
import tompkins.ui.file.BackgroundTask;
import tompkins.ui.file.ChosenFile;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Texts;

/** A button that shows what a file held, such as a picture or a mesh, and chooses another file. */
public final class FileContentEditor implements ValueEditor {

    /** Client property of a window's root pane: the {@link Choosers} for the editors in it. */
    public static final String CHOOSERS = "tompkins.choosers";

    /** Makes file choosers that start where a file was used last. */
    public interface Choosers {

        /** The next chooser. */
        JFileChooser chooser();

        /** Tells that a chosen file could be used. */
        void used(Path file);
    }

    private final JButton button = new JButton();
    private final Function<Object, String> text;

    /** An editor for pictures. */
    static FileContentEditor picture(String name, String tip, Note note, Consumer<Object> commit) {
        return new FileContentEditor(name, tip, note, commit, PictureFile::read, FileContentEditor::pictureText);
    }

    /** An editor for meshes. */
    static FileContentEditor mesh(String name, String tip, Note note, Consumer<Object> commit) {
        return new FileContentEditor(name, tip, note, commit, MeshFile::read, FileContentEditor::meshText);
    }

    private interface Reader {
        Object read(Path file) throws IOException;
    }

    private FileContentEditor(
            String name, String tip, Note note, Consumer<Object> commit, Reader reader, Function<Object, String> text) {
        this.text = text;
        button.setName(name);
        Naming.tip(button, tip);
        button.addActionListener(event -> {
            JFileChooser chooser = choosers().map(Choosers::chooser).orElseGet(JFileChooser::new);
            if (chooser.showOpenDialog(button) == JFileChooser.APPROVE_OPTION) {
                ChosenFile.path(button, chooser.getSelectedFile()).ifPresent(file -> read(file, reader, note, commit));
            }
        });
    }

    private Optional<Choosers> choosers() {
        return SwingUtilities.getRootPane(button).getClientProperty(CHOOSERS) instanceof Choosers choosers
                ? Optional.of(choosers)
                : Optional.empty();
    }

    /** Reads in the background: a mesh may be large. If the form is gone by then, the result is dropped. */
    private void read(Path file, Reader reader, Note note, Consumer<Object> commit) {
        BackgroundTask.find(
                SwingUtilities.getWindowAncestor(button),
                Texts.get("file.opening", file),
                () -> afterReading(file, reader, note, commit),
                Runnable::run);
    }

    /** Reads a file, and returns what has to be done afterwards. */
    private Runnable afterReading(Path file, Reader reader, Note note, Consumer<Object> commit) {
        try {
            Object content = reader.read(file);
            return () -> {
                if (button.isShowing()) {
                    choosers().ifPresent(choosers -> choosers.used(file));
                    note.attempt(() -> commit.accept(content));
                }
            };
        } catch (IOException problem) {
            return () -> note.setError(problem.getMessage());
        }
    }

    private static String pictureText(Object value) {
        PixelPicture picture = (PixelPicture) value;
        return picture.name().isEmpty()
                ? Texts.get("pixels.choose")
                : Texts.get("pixels.button", picture.name(), picture.width(), picture.height());
    }

    private static String meshText(Object value) {
        MeshData mesh = (MeshData) value;
        return mesh.name().isEmpty()
                ? Texts.get("mesh.choose")
                : Texts.get("mesh.button", mesh.name(), mesh.triangles());
    }

    @Override
    public JComponent component() {
        return button;
    }

    @Override
    public void show(Object value) {
        button.setText(text.apply(value));
        button.getAccessibleContext().setAccessibleName(button.getName() + ": " + button.getText());
    }
}
