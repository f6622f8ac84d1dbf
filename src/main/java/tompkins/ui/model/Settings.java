package tompkins.ui.model;

import java.io.IOException;
import java.io.StringReader;
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
import java.util.stream.Stream;
import tompkins.file.FileException;
import tompkins.file.PendingFile;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.Texts;

/**
 * What the window remembers: its look, its size, and the files that were opened last. Kept in the folder for settings
 * of the user, or in the one that the system property {@code tompkins.settings} names.
 */
public final class Settings {

    private static final String FILE = "window.properties";
    private static final String RECENT = "recent.";
    private static final int MOST_RECENT = 8;

    /** Larger than any file that was written by this program. */
    private static final int LARGEST = 1 << 20;

    /** Null if nothing can be kept. */
    private final Path file;

    private Properties values;

    /** What was set since the last saving: another program may have set something else in the file meanwhile. */
    private final List<Consumer<Properties>> changes = new ArrayList<>();

    /** What the user should know about the settings; empty if there is nothing. */
    private String trouble;

    /** Told of it, once; null before it is asked for, and after that. */
    private Consumer<String> listener;

    /** The settings as they were kept the last time. */
    public Settings() {
        this(SettingsFolder.find());
    }

    private Settings(SettingsFolder folder) {
        this(folder.path() == null ? null : folder.path().resolve(FILE), folder.trouble());
    }

    /** Settings in a file; whatever cannot be read counts as not set. */
    public Settings(Path file) {
        this(file, "");
    }

    private Settings(Path file, String trouble) {
        this.file = file == null ? null : file.toAbsolutePath();
        this.trouble = trouble;
        values = kept();
    }

    /** What the file holds; nothing if it cannot be read. */
    private Properties kept() {
        Properties kept = new Properties();
        if (file == null || Files.notExists(file)) {
            return kept;
        }
        try {
            if (!Files.isRegularFile(file) || Files.size(file) > LARGEST) {
                throw new IOException(Texts.get("settings.notOurs"));
            }
            kept.load(new StringReader(Files.readString(file)));
            return kept;
        } catch (CharacterCodingException | IllegalArgumentException damaged) {
            tell(Texts.get("settings.notRead", file, Texts.get("settings.notOurs")));
        } catch (IOException failure) {
            tell(Texts.get("settings.notRead", file, FileException.reason(failure)));
        }
        return new Properties();
    }

    /** Tells somebody what the user should know about the settings, now or when it happens; once. */
    public void tellTrouble(Consumer<String> newListener) {
        listener = newListener;
        tell(trouble);
    }

    private void tell(String message) {
        trouble = message;
        if (listener != null && !message.isEmpty()) {
            listener.accept(message);
            listener = null;
        }
    }

    /** The look; light if none was chosen. */
    public Look look() {
        String name = text("look", "");
        return Stream.of(Look.values())
                .filter(look -> look.name().equals(name))
                .findFirst()
                .orElse(Look.LIGHT);
    }

    /** Keeps the colours of the window. */
    public void setLook(Look look) {
        setText("look", look.name());
        save();
    }

    /** A text, or another one if it was never set. */
    public String text(String name, String other) {
        return values.getProperty(name, other);
    }

    /** Keeps a text under a name. */
    public void setText(String name, String text) {
        change(properties -> properties.setProperty(name, text));
    }

    private void change(Consumer<Properties> change) {
        change.accept(values);
        changes.add(change);
    }

    /** A number, or another one if it was never set. */
    public int number(String name, int other) {
        try {
            return Integer.parseInt(text(name, ""));
        } catch (NumberFormatException unset) {
            return other;
        }
    }

    /** Keeps a whole number under a name. */
    public void setNumber(String name, int value) {
        setText(name, Integer.toString(value));
    }

    /** The files that were opened or saved last, the newest first. */
    public List<Path> recentFiles() {
        return recentFiles(values);
    }

    private static List<Path> recentFiles(Properties properties) {
        List<Path> files = new ArrayList<>();
        for (int i = 0; i < MOST_RECENT; i++) {
            try {
                files.add(Path.of(properties.getProperty(RECENT + i, "")));
            } catch (InvalidPathException damaged) {
                // it counts as not set
            }
        }
        // a root has no name and is not a file
        files.removeIf(path -> path.getFileName() == null || path.toString().isEmpty());
        return files;
    }

    /** Puts a file first among the recent ones. */
    public void addRecentFile(Path opened) {
        Path absolute = opened.toAbsolutePath();
        change(properties -> {
            List<Path> files = recentFiles(properties);
            files.remove(absolute);
            files.add(0, absolute);
            for (int i = 0; i < Math.min(MOST_RECENT, files.size()); i++) {
                properties.setProperty(RECENT + i, files.get(i).toString());
            }
        });
        save();
    }

    /**
     * Puts what was set into the file, beside what other programs have set there; if the folder cannot be written,
     * nothing is remembered, and the user is told so.
     */
    public void save() {
        if (file == null) {
            return;
        }
        Properties now = kept();
        changes.forEach(change -> change.accept(now));
        try {
            Files.createDirectories(file.getParent());
            StringWriter text = new StringWriter();
            now.store(text, null);
            PendingFile.save(file, true, out -> out.write(text.toString().getBytes(StandardCharsets.UTF_8)));
            values = now;
            changes.clear();
        } catch (IOException | UncheckedIOException failure) {
            tell(Texts.get("settings.notKept", file, FileException.reason(failure)));
        }
    }
}
