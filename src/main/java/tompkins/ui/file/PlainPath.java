package tompkins.ui.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** The one name by which the window knows a file, however it was named when it was opened. */
public final class PlainPath {

    private PlainPath() {}

    /** The whole path of a file, without the parts {@code .} and {@code ..} where they can be left out. */
    public static Path of(Path file) {
        Path whole = file.toAbsolutePath();
        Path plain = whole.normalize();
        try {
            // behind a symbolic link, .. leads elsewhere
            return Files.isSameFile(plain, whole) ? plain : whole;
        } catch (IOException notThere) {
            return whole;
        }
    }
}
