package tompkins.ui.file;

import java.io.File;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import javax.swing.filechooser.FileFilter;

/** A choice of a file chooser that stands for a format. */
public final class FormatFilter<T> extends FileFilter {

    private final T format;
    private final String description;
    private final List<String> endings;

    /** A filter; a format without endings is a folder. */
    public FormatFilter(T format, String description, List<String> endings) {
        this.format = format;
        this.description = description;
        this.endings = endings;
    }

    T format() {
        return format;
    }

    List<String> endings() {
        return endings;
    }

    boolean isFolder() {
        return endings.isEmpty();
    }

    /** Whether a name has an ending of the format. */
    boolean fits(String name) {
        String inSmallLetters = name.toLowerCase(Locale.ROOT);
        return endings.stream().anyMatch(inSmallLetters::endsWith);
    }

    /** The file with an ending of the format. */
    Path named(Path file) {
        return isFolder() || fits(file.getFileName().toString())
                ? file
                : file.resolveSibling(file.getFileName() + endings.get(0));
    }

    @Override
    public boolean accept(File file) {
        return file.isDirectory() || fits(file.getName());
    }

    @Override
    public String getDescription() {
        return description;
    }
}
