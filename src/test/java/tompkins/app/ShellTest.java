package tompkins.app;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import tompkins.OnLinux;

/** Tests of the program as a process of its own, in a folder that only they use. */
@OnLinux
abstract class ShellTest {

    @TempDir
    Path folder;

    /** Runs a line of the shell in the folder. */
    final ProgramRun shell(String line) throws IOException, InterruptedException {
        return ProgramShell.run(folder, line);
    }

    /** Writes {@code small.json}, whose picture is soon taken. */
    final void writeSmallScene() throws IOException {
        Files.writeString(
                folder.resolve("small.json"), "{\"settings\": {\"width\": 32, \"height\": 24, \"samples\": 1}}");
    }
}
