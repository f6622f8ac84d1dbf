package tompkins.ui.model;

import java.io.File;
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
import java.util.function.UnaryOperator;
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

    private static final String PROPERTY = "tompkins.settings";
    private static final String PROGRAM = "tompkins";
    private static final String FILE = "window.properties";
    private static final String RECENT = "recent.";
    private static final int MOST_RECENT = 8;

    /** Larger than any file that was written by this program. */
    private static final int LARGEST = 1 << 20;

    /** Null if nothing can be kept. */
    private final Path file;

    private final Properties values = new Properties();

    /** What the user should know about the settings; empty if there is nothing. */
    private String trouble = "";

    /** Told of it, once; null before it is asked for, and after that. */
    private Consumer<String> listener;

    /** The settings as they were kept the last time. */
    public Settings() {
        this(find());
        if (file == null) {
            tell(Texts.get("settings.noFolder"));
        }
    }

    /** Settings in a file; whatever cannot be read counts as not set, and so does all if the file is null. */
    public Settings(Path file) {
        this.file = file == null ? null : file.toAbsolutePath();
        read();
    }

    private static Path find() {
        try {
            return file(System::getProperty, System::getenv);
        } catch (InvalidPathException notAName) {
            return null;
        }
    }

    /**
     * The file in the folder that the system property names, or else in the one for settings of the user.
     *
     * @param property the system's properties by their names; null for what is not set
     * @param environment the environment in the same way
     */
    static Path file(UnaryOperator<String> property, UnaryOperator<String> environment) {
        String chosen = property.apply(PROPERTY);
        if (chosen != null && !chosen.isEmpty()) {
            return Path.of(chosen, FILE);
        }
        // by the XDG Base Directory Specification, a path that is empty or relative counts as not set
        return Stream.of("APPDATA", "XDG_CONFIG_HOME")
                .map(environment)
                .filter(folder -> folder != null && new File(folder).isAbsolute())
                .findFirst()
                .map(folder -> Path.of(folder, PROGRAM, FILE))
                .orElseGet(() -> Path.of(property.apply("user.home"), ".config", PROGRAM, FILE));
    }

    /** Takes what the file holds; nothing if it cannot be read. */
    private void read() {
        if (file == null || Files.notExists(file)) {
            return;
        }
        try {
            if (!Files.isRegularFile(file) || Files.size(file) > LARGEST) {
                throw new IOException(Texts.get("settings.notOurs"));
            }
            Properties kept = new Properties();
            kept.load(new StringReader(Files.readString(file)));
            values.putAll(kept);
        } catch (CharacterCodingException | IllegalArgumentException damaged) {
            tell(Texts.get("settings.notRead", file, Texts.get("settings.notOurs")));
        } catch (IOException failure) {
            tell(Texts.get("settings.notRead", file, FileException.reason(failure)));
        }
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
    }

    /** A text, or another one if it was never set. */
    public String text(String name, String other) {
        return values.getProperty(name, other);
    }

    /** Keeps a text under a name. */
    public void setText(String name, String text) {
        // another program may have set something else meanwhile
        read();
        values.setProperty(name, text);
        write();
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
        List<Path> files = new ArrayList<>();
        for (int i = 0; i < MOST_RECENT; i++) {
            try {
                files.add(Path.of(text(RECENT + i, "")));
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
        read();
        List<Path> files = recentFiles();
        files.remove(opened.toAbsolutePath());
        files.add(0, opened.toAbsolutePath());
        for (int i = 0; i < Math.min(MOST_RECENT, files.size()); i++) {
            values.setProperty(RECENT + i, files.get(i).toString());
        }
        write();
    }

    /** If the folder cannot be written, nothing is remembered, and the user is told so. */
    private void write() {
        if (file == null) {
            return;
        }
        try {
            Files.createDirectories(file.getParent());
            StringWriter text = new StringWriter();
            values.store(text, null);
            PendingFile.save(file, true, out -> out.write(text.toString().getBytes(StandardCharsets.UTF_8)));
        } catch (IOException | UncheckedIOException failure) {
            tell(Texts.get("settings.notKept", file, FileException.reason(failure)));
        }
    }
}
