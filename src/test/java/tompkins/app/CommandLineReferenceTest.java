package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.GeneratedDocument;

class CommandLineReferenceTest {

    /** Lines of help that fit on a screen. */
    private static final int SCREEN = 60;

    @Test
    void fileIsUpToDate() throws IOException {
        GeneratedDocument.assertUpToDate("command-line.md", CommandLineReference.markdown(), getClass());
    }

    static List<String> commands() {
        return List.copyOf(CommandLineReference.commands().keySet());
    }

    @ParameterizedTest
    @MethodSource("commands")
    void helpFitsOnAScreen(String command) {
        assertThat(ProgramRun.of("help", command).out().lines())
                .hasSizeBetween(4, SCREEN)
                .allMatch(line -> line.length() <= 80);
    }
}
