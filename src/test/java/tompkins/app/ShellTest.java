package tompkins.app;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import tompkins.OnLinux;
import tompkins.RunningJava;

/** Tests of the program as a process of its own, in a folder that only they use. */
@OnLinux
abstract class ShellTest {

    /** The program for those who call it by another name. */
    static final String PROGRAM =
            "\"$JAVA\" $OPTIONS -Xmx64m -Xshare:auto -XX:-UsePerfData -XX:TieredStopAtLevel=1 " + Main.class.getName();

    @TempDir
    Path folder;

    /** Runs a line of the shell in the folder. */
    final ProgramRun shell(String line) throws IOException, InterruptedException {
        return run(folder, line);
    }

    /** What a line of the shell prints, and its exit code. */
    static ProgramRun run(Path folder, String line) throws IOException, InterruptedException {
        Path err = folder.resolve("err");
        ProcessBuilder builder = new ProcessBuilder("sh", "-c", "tompkins() { " + PROGRAM + " \"$@\"; }; " + line);
        builder.environment().put("JAVA", RunningJava.PROGRAM);
        builder.environment().put("CLASSPATH", RunningJava.CLASS_PATH);
        Process process =
                builder.directory(folder.toFile()).redirectError(err.toFile()).start();
        String out = new String(process.getInputStream().readAllBytes(), UTF_8);
        return new ProgramRun(process.waitFor(), out, Files.readString(err));
    }

    /** Writes {@code small.json}, whose picture is soon taken. */
    final void writeSmallScene() throws IOException {
        Files.writeString(
                folder.resolve("small.json"), "{\"settings\": {\"width\": 32, \"height\": 24, \"samples\": 1}}");
    }
}
