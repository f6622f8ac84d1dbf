package tompkins.ui;

import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JFileChooser;
import tompkins.image.PictureException;
import tompkins.image.PictureFile;
import tompkins.ray.PixelPicture;

/** A button that shows the file of a picture, and chooses another one. */
final class PixelPictureEditor implements ValueEditor {

    private final JButton button = new JButton();

    PixelPictureEditor(String name, String tip, Note note, Consumer<Object> commit) {
        button.setName(name);
        button.setToolTipText(Tips.html(tip));
        button.addActionListener(event -> {
            JFileChooser chooser = new JFileChooser();
            if (chooser.showOpenDialog(button) == JFileChooser.APPROVE_OPTION) {
                try {
                    PixelPicture picture =
                            PictureFile.read(chooser.getSelectedFile().toPath());
                    ValueEditors.attempt(note, () -> commit.accept(picture));
                } catch (PictureException e) {
                    note.setError(e.getMessage());
                }
            }
        });
    }

    @Override
    public JComponent component() {
        return button;
    }

    @Override
    public void show(Object value) {
        PixelPicture picture = (PixelPicture) value;
        String name = picture.name().isEmpty() ? Texts.get("pixels.none") : picture.name();
        button.setText(Texts.get("pixels.button", name, picture.width(), picture.height()));
        button.getAccessibleContext().setAccessibleName(button.getName() + ": " + button.getText());
    }
}
