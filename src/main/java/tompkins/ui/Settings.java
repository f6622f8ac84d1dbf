package tompkins.ui;

import java.io.IOException;
import java.io.Reader;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Properties;
import java.util.function.Consumer;
import tompkins.image.FileFailure;
import tompkins.image.PendingFile;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.Texts;

/**
 * What the window remembers: its look, its size, and the files that were opened last. Kept in the folder for settings
 * of the user, or in the one that the system property {@code tompkins.settings} names.
 */
final class Settings {

    private static final String FILE = "window.properties";
    private static final int MOST_RECENT = 8;

    /** Larger than any file that was written by this program. */
    private static final int LARGEST = 1 << 20;

    /** Null if nothing can be kept. */
    private final Path file;

    private final Properties values = new Properties();

    /** What the user should know about the settings; empty if there is nothing, or it was already told. */
    private String trouble;

    private boolean told;
    private Consumer<String> listener;

    Settings() {
        this(SettingsFolder.find());
    }

    private Settings(SettingsFolder folder) {
        this(folder.path() == null ? null : folder.path().resolve(FILE), folder.trouble());
    }

    /** Settings in a file; whatever cannot be read counts as not set. */
    Settings(Path file) {
        this(file, "");
    }

    private Settings(Path file, String trouble) {
        this.file = file == null ? null : file.toAbsolutePath();
        this.trouble = trouble;
        // even in a folder that cannot be read there may be a file
        if (file != null && !Files.notExists(file)) {
            read();
        }
    }

    private void read() {
        try {
            if (Files.exists(file) && (!Files.isRegularFile(file) || Files.size(file) > LARGEST)) {
                throw new IOException(Texts.get("settings.notOurs"));
            }
            try (Reader reader = Files.newBufferedReader(file)) {
                values.load(reader);
            }
        } catch (CharacterCodingException | IllegalArgumentException damaged) {
            values.clear();
            tell(Texts.get("settings.notRead", file, Texts.get("settings.notOurs")));
        } catch (IOException failure) {
            values.clear();
            tell(Texts.get("settings.notRead", file, FileFailure.reason(failure)));
        }
    }

    /** Tells somebody what the user should know about the settings, now or when it happens; once. */
    void tellTrouble(Consumer<String> newListener) {
        listener = newListener;
        tell(trouble);
    }

    private void tell(String message) {
        trouble = message;
        if (listener != null && !told && !message.isEmpty()) {
            told = true;
            listener.accept(message);
        }
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
                    // it counts as not set
                }
            }
        }
        // a root has no name and is not a file
        files.removeIf(path -> path.getFileName() == null || path.toString().isEmpty());
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

    /** Writes the file; if the folder cannot be written, nothing is remembered, and the user is told so. */
    void save() {
        if (file == null) {
            return;
        }
        try {
            Files.createDirectories(file.getParent());
            try (PendingFile pending = PendingFile.replacing(file)) {
                StringWriter text = new StringWriter();
                values.store(text, null);
                pending.write(text.toString().getBytes(StandardCharsets.UTF_8));
                pending.commit();
            }
        } catch (IOException | UncheckedIOException failure) {
            IOException reason = failure instanceof IOException io ? io : ((UncheckedIOException) failure).getCause();
            tell(Texts.get("settings.notKept", file, FileFailure.reason(reason)));
        }
    }
}
