package tompkins.ui;

import java.io.IOException;
import java.io.Reader;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Properties;
import tompkins.image.PendingFile;
import tompkins.ui.widget.Look;

/**
 * What the window remembers: its look, its size, and the files that were opened last. Kept in the folder for settings
 * of the user, or in the one that the system property {@code tompkins.settings} names.
 */
final class Settings {

    private static final String FOLDER = "tompkins.settings";
    private static final int MOST_RECENT = 8;

    private final Path file;
    private final Properties values = new Properties();

    Settings() {
        this(folder().resolve("window.properties"));
    }

    /** Settings in a file; whatever cannot be read is as if it had not been set. */
    Settings(Path file) {
        this.file = file;
        if (Files.isReadable(file)) {
            try (Reader reader = Files.newBufferedReader(file)) {
                values.load(reader);
            } catch (IOException | IllegalArgumentException damaged) {
                values.clear();
            }
        }
    }

    private static Path folder() {
        String chosen = System.getProperty(FOLDER);
        if (chosen != null) {
            return Path.of(chosen);
        }
        String windows = System.getenv("APPDATA");
        String linux = System.getenv("XDG_CONFIG_HOME");
        String home = System.getProperty("user.home") + "/.config";
        // an empty one is as if it were not set, by the XDG Base Directory Specification
        String base = windows != null ? windows : linux != null && !linux.isEmpty() ? linux : home;
        return Path.of(base).resolve("tompkins");
    }

    /** The look; light if none was chosen. */
    Look look() {
        String name = values.getProperty("look", Look.LIGHT.name());
        for (Look look : Look.values()) {
            if (look.name().equals(name)) {
                return look;
            }
        }
        return Look.LIGHT;
    }

    void setLook(Look look) {
        values.setProperty("look", look.name());
        save();
    }

    /** A number, or another one if it was never set. */
    int number(String name, int other) {
        try {
            return Integer.parseInt(values.getProperty(name, Integer.toString(other)));
        } catch (NumberFormatException damaged) {
            return other;
        }
    }

    void setNumber(String name, int value) {
        values.setProperty(name, Integer.toString(value));
    }

    /** The files that were opened or saved last, the newest first. */
    List<Path> recentFiles() {
        List<Path> files = new ArrayList<>();
        for (int i = 0; i < MOST_RECENT; i++) {
            String name = values.getProperty("recent." + i);
            if (name != null) {
                try {
                    files.add(Path.of(name));
                } catch (InvalidPathException damaged) {
                    // as if it had not been set
                }
            }
        }
        return files;
    }

    void addRecentFile(Path opened) {
        List<Path> files = new ArrayList<>(recentFiles());
        Path absolute = opened.toAbsolutePath();
        files.remove(absolute);
        files.add(0, absolute);
        for (int i = 0; i < Math.min(MOST_RECENT, files.size()); i++) {
            values.setProperty("recent." + i, files.get(i).toString());
        }
        save();
    }

    /** Writes the file; a folder that cannot be written only means that nothing is remembered. */
    void save() {
        try {
            Files.createDirectories(file.getParent());
            try (PendingFile pending = PendingFile.file(file)) {
                try (Writer writer = Files.newBufferedWriter(pending.path())) {
                    values.store(writer, null);
                }
                pending.commit();
            }
        } catch (IOException | UncheckedIOException | SecurityException notRemembered) {
            return;
        }
    }
}
