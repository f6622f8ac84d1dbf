package tompkins.ui;

import java.io.IOException;
import java.nio.file.Path;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JFileChooser;
import tompkins.image.PictureFile;
import tompkins.io.MeshFile;
import tompkins.ray.MeshData;
import tompkins.ray.PixelPicture;

/** A button that shows what a file held, such as a picture or a mesh, and chooses another file. */
final class FileContentEditor implements ValueEditor {

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
        button.setToolTipText(Tips.html(tip));
        button.addActionListener(event -> {
            JFileChooser chooser = new JFileChooser();
            if (chooser.showOpenDialog(button) == JFileChooser.APPROVE_OPTION) {
                try {
                    Object content = reader.read(chooser.getSelectedFile().toPath());
                    ValueEditors.attempt(note, () -> commit.accept(content));
                } catch (IOException e) {
                    note.setError(e.getMessage());
                }
            }
        });
    }

    private static String pictureText(Object value) {
        PixelPicture picture = (PixelPicture) value;
        String name = picture.name().isEmpty() ? Texts.get("pixels.none") : picture.name();
        return Texts.get("pixels.button", name, picture.width(), picture.height());
    }

    private static String meshText(Object value) {
        MeshData mesh = (MeshData) value;
        String name = mesh.name().isEmpty() ? Texts.get("mesh.none") : mesh.name();
        return Texts.get("mesh.button", name, mesh.triangles());
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
