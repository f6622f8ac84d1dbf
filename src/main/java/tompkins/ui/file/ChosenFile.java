package tompkins.ui.file;

import java.awt.Component;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Optional;
import tompkins.property.OneLine;
import tompkins.ui.widget.Messages;
import tompkins.ui.widget.Texts;

/** A file as choosers and drops give it, whose name may be one that the system or its locale does not allow. */
public final class ChosenFile {

    private ChosenFile() {}

    /** The path of a file; empty if no file can have its name; a message over a component then says so. */
    public static Optional<Path> path(Component parent, File file) {
        try {
            return Optional.of(file.toPath());
        } catch (InvalidPathException notAName) {
            Messages.error(parent, Texts.get("file.noName", OneLine.of(file.getName())));
            return Optional.empty();
        }
    }

    /**
     * The one name by which the window knows a file, however it was named: its whole path, without the parts {@code .}
     * and {@code ..} where they can be left out.
     */
    public static Path plain(Path file) {
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
