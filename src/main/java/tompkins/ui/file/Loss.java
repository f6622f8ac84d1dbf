package tompkins.ui.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import tompkins.image.PhotographFile;
import tompkins.io.StudioReader;
import tompkins.io.StudioWriter;
import tompkins.property.MistakeException;
import tompkins.studio.Studio;

/** What is lost when a scene is saved over its file. */
public enum Loss {
    /** The file holds the scene as it was read or saved, and nothing else. */
    NOTHING,

    /** The comments and the layout of someone who wrote the file by hand. */
    HANDWRITING,

    /** The photograph that held the scene. */
    PHOTOGRAPH,

    /** Another scene, which another program put there. */
    OTHER_SCENE;

    /** What is lost of a file that held a studio when it was last opened or saved. Reads the file. */
    public static Loss of(Path file, Studio held) {
        try {
            if (PhotographFile.isPicture(file)) {
                return PHOTOGRAPH;
            }
            // programs that keep versions may change the ends of lines
            String text = Files.readString(file).replace("\r\n", "\n");
            if (text.equals(StudioWriter.write(held, file))) {
                return NOTHING;
            }
            return StudioReader.read(file).equals(held) ? HANDWRITING : OTHER_SCENE;
        } catch (NoSuchFileException gone) {
            return NOTHING;
        } catch (IOException | MistakeException noScene) {
            return OTHER_SCENE;
        }
    }
}
