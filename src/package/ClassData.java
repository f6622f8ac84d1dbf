import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Lets a packaged program start faster: makes the classes that it loads ready for its own Java machine. In two steps, each
 * with the folder of the Java machine and that of the jar:
 *
 * <p>{@code java ClassData.java list RUNTIME APP SCENE} writes {@code classes.lst}, the classes that a picture takes that
 * is rendered and, if there is a display, the window. {@code java ClassData.java archive RUNTIME APP} lets Java's
 * class-data sharing make {@code tompkins.jsa} from the list. An archive holds for one jar at one place: an installer has
 * to repeat the second step ({@code src/package/linux/postinst}).
 */
public final class ClassData {

    private static final int WINDOW_SECONDS = 4;

    private final String java;
    private final Path classes;
    private final Path archive;
    private final String jar;
    private final Path work;

    private ClassData(Path runtime, Path app) throws IOException {
        java = runtime.resolve("bin/java").toString();
        classes = app.resolve("classes.lst");
        archive = app.resolve("tompkins.jsa");
        jar = app.resolve("tompkins.jar").toAbsolutePath().normalize().toString();
        work = Files.createTempDirectory("class-data");
    }

    /** Takes the step that the first argument names. */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        ClassData data = new ClassData(Path.of(arguments[1]), Path.of(arguments[2]));
        switch (arguments[0]) {
            case "list" -> data.list(arguments[3]);
            case "archive" -> data.makeArchive();
            default -> throw new IllegalArgumentException(arguments[0]);
        }
    }

    private void list(String scene) throws IOException, InterruptedException {
        Path rendered = work.resolve("render.lst");
        run(listing(rendered, "render", scene, "--size", "64x48", "-o", work + "/picture.png"));
        Set<String> names = named(rendered);
        if (System.getenv("DISPLAY") != null || !System.getProperty("os.name").startsWith("Linux")) {
            Path shown = work.resolve("window.lst");
            Process window = start(listing(shown));
            if (window.waitFor(WINDOW_SECONDS, TimeUnit.SECONDS)) {
                throw new IOException("the window ended with exit code " + window.exitValue());
            }
            window.destroy();
            window.waitFor();
            names.addAll(named(shown));
        }
        Files.write(classes, names);
    }

    /** The classes of a list. With those of lambdas, JDK 17 fails to write an archive. */
    private static Set<String> named(Path list) throws IOException {
        try (Stream<String> lines = Files.lines(list)) {
            return lines.filter(line -> !line.startsWith("@lambda")).collect(Collectors.toCollection(LinkedHashSet::new));
        }
    }

    private void makeArchive() throws IOException, InterruptedException {
        run(List.of(
                java, "-Xshare:dump", "-XX:SharedClassListFile=" + classes, "-XX:SharedArchiveFile=" + archive, "-cp", jar));
    }

    private List<String> listing(Path list, String... arguments) {
        List<String> command = new ArrayList<>(List.of(
                java, "-Xshare:off", "-XX:DumpLoadedClassList=" + list, "-Dtompkins.settings=" + work, "-jar", jar));
        command.addAll(List.of(arguments));
        return command;
    }

    private Process start(List<String> command) throws IOException {
        return new ProcessBuilder(command)
                .redirectErrorStream(true)
                .redirectOutput(work.resolve("output.txt").toFile())
                .start();
    }

    private void run(List<String> command) throws IOException, InterruptedException {
        if (start(command).waitFor() != 0) {
            throw new IOException(String.join(" ", command) + " failed: " + Files.readString(work.resolve("output.txt")));
        }
    }
}
