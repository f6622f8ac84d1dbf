import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/**
 * Lets a packaged program start faster: makes the classes that it loads ready for its own Java machine. In two steps, each
 * with the folder of the Java machine and that of the jar:
 *
 * <p>{@code java ClassData.java list RUNTIME APP SCENE} writes {@code classes.lst}, the classes that the window takes up
 * to its first picture or, without a display, a picture that is rendered. {@code java ClassData.java archive RUNTIME APP} lets Java's
 * class-data sharing make {@code tompkins.jsa} from the list. An archive holds for one jar at one place: an installer has
 * to repeat the second step ({@code src/package/linux/postinst}).
 */
public final class ClassData {

    /** The window loads it when it shows the first picture. All later classes would make the archive a quarter larger. */
    private static final String OF_FIRST_PICTURE = "tompkins/image/PictureLabel";

    /**
     * A library in a format so old that JDK 17 archives none of its classes, and crashes at the lambdas that make them.
     */
    private static final String NOT_ARCHIVED = "picocli/";

    private static final int MOST_SECONDS = 120;
    private static final int INTERVAL_MILLISECONDS = 50;

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
        try {
            switch (arguments[0]) {
                case "list" -> data.list(arguments[3]);
                case "archive" -> data.makeArchive();
                default -> throw new IllegalArgumentException(arguments[0]);
            }
        } finally {
            data.tidy();
        }
    }

    /** Leaves nothing behind in the folder for temporary files of whoever installs the program. */
    private void tidy() throws IOException {
        try (Stream<Path> all = Files.walk(work)) {
            for (Path path : all.sorted(Comparator.reverseOrder()).toList()) {
                Files.delete(path);
            }
        }
    }

    private void list(String scene) throws IOException, InterruptedException {
        Path loaded = work.resolve("loaded.lst");
        boolean hasDisplay =
                System.getenv("DISPLAY") != null || !System.getProperty("os.name").startsWith("Linux");
        if (hasDisplay) {
            openWindow(loaded);
        } else {
            run(listing(loaded, "render", scene, "--size", "64x48", "-o", work + "/picture.png"));
        }
        try (Stream<String> lines = Files.lines(loaded)) {
            Files.write(
                    classes,
                    lines.takeWhile(line -> !hasDisplay || !line.startsWith(OF_FIRST_PICTURE))
                            .filter(line -> !line.contains(NOT_ARCHIVED))
                            .distinct()
                            .toList());
        }
    }

    /** Opens the window until its first picture is there. */
    private void openWindow(Path loaded) throws IOException, InterruptedException {
        Process window = start(listing(loaded));
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(MOST_SECONDS);
        while (!Files.exists(loaded) || !Files.readString(loaded).contains(OF_FIRST_PICTURE)) {
            if (window.waitFor(INTERVAL_MILLISECONDS, TimeUnit.MILLISECONDS) || System.nanoTime() > end) {
                window.destroy();
                throw new IOException("the window shows no picture: " + Files.readString(work.resolve("output.txt")));
            }
        }
        window.destroy();
        window.waitFor();
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
