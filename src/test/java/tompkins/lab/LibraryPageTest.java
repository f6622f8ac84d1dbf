package tompkins.lab;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tompkins.RunningJava;

/** The program that {@code docs/library.md} prints runs as it stands there. */
class LibraryPageTest {

    private static final Pattern PROGRAM = Pattern.compile("```java\n(.*?)```", Pattern.DOTALL);

    @TempDir
    private Path folder;

    @Test
    void programOfThePageRuns() throws IOException, InterruptedException {
        Matcher program = PROGRAM.matcher(Files.readString(Path.of("docs/library.md")));
        assertThat(program.find()).isTrue();
        String scenes = Path.of("scenes").toAbsolutePath().toString().replace('\\', '/');
        Files.writeString(folder.resolve("Sweep.java"), program.group(1).replace("\"scenes/", '"' + scenes + '/'));

        Process run = new ProcessBuilder(
                        RunningJava.PROGRAM, "-XX:TieredStopAtLevel=1", "-cp", RunningJava.CLASS_PATH, "Sweep.java")
                .directory(folder.toFile())
                .redirectErrorStream(true)
                .start();
        String printed = new String(run.getInputStream().readAllBytes(), StandardCharsets.UTF_8);

        assertThat(run.waitFor()).as(printed).isZero();
        // both points are 6 beside the axis, 1 above it and 40 ahead
        double rest = Math.toDegrees(Math.acos((-36 + 1 + 1600) / (36.0 + 1 + 1600)));
        assertThat(printed)
                .startsWith("square.png")
                .contains(String.format(Locale.ROOT, "0.00 c: %.3f degrees", rest))
                .contains("\"hits\"");
        assertThat(folder.resolve("square.png")).exists();
    }
}
