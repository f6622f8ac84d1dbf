package tompkins.app;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The program as a process of its own, with what it can have there alone: little memory, and an output that is lost. */
class ProgramProcessTest {

    @TempDir
    private Path folder;

    /** Runs the program with a shell, in which {@code tompkins} is its name. */
    private ProgramRun shell(String line) throws IOException, InterruptedException {
        Path err = folder.resolve("err");
        ProcessBuilder builder = new ProcessBuilder(
                "sh",
                "-c",
                "tompkins() { \"$JAVA\" -Xmx64m -Xshare:auto -XX:-UsePerfData " + Main.class.getName() + " \"$@\"; }; "
                        + line);
        builder.environment()
                .put(
                        "JAVA",
                        Path.of(System.getProperty("java.home"), "bin", "java").toString());
        builder.environment().put("CLASSPATH", System.getProperty("java.class.path"));
        Process process =
                builder.directory(folder.toFile()).redirectError(err.toFile()).start();
        String out = new String(process.getInputStream().readAllBytes(), UTF_8);
        return new ProgramRun(process.waitFor(), out, Files.readString(err));
    }

    @Test
    void aSceneThatTheMemoryCannotHoldIsSaidInOneLine() throws IOException, InterruptedException {
        Files.writeString(folder.resolve("rods.json"), """
                { "scene": [{ "type": "CylinderLattice", "points": [1000, 1000, 1000] }] }
                """);

        ProgramRun run = shell("tompkins check rods.json");

        assertThat(run.err()).matches("not enough memory: Java may use 6\\d MB; start java with a larger -Xmx\n");
        assertThat(run.out()).isEmpty();
        assertThat(run.code()).isEqualTo(Failures.FAILURE);
    }
}
