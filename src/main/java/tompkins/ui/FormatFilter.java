package tompkins.ui;

import java.io.File;
import java.util.List;
import java.util.Locale;
import javax.swing.filechooser.FileFilter;

/** A choice of a file chooser that stands for a format. */
final class FormatFilter<T> extends FileFilter {

    private final T format;
    private final String description;
    private final List<String> endings;

    /** A filter; a format without endings is a folder. */
    FormatFilter(T format, String description, List<String> endings) {
        this.format = format;
        this.description = description;
        this.endings = endings;
    }

    T format() {
        return format;
    }

    @Override
    public boolean accept(File file) {
        String name = file.getName().toLowerCase(Locale.ROOT);
        return file.isDirectory() || endings.stream().anyMatch(name::endsWith);
    }

    @Override
    public String getDescription() {
        return description;
    }
}
