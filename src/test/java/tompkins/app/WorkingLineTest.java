package tompkins.app;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import org.junit.jupiter.api.Test;

/** What is shown while a command computes and prints nothing. */
class WorkingLineTest {

    private final ByteArrayOutputStream terminal = new ByteArrayOutputStream();

    private WorkingLine line(boolean watched) {
        return new WorkingLine(new PrintStream(terminal, true, UTF_8), watched);
    }

    @Test
    void theLineOnATerminalGoesBeforeAnythingIsPrinted() throws IOException {
        WorkingLine line = line(true);
        WatchedStream out = new WatchedStream(terminal, line);
        line.secondPassed();
        line.secondPassed();
        out.write("result\n".getBytes(UTF_8));
        out.write("more\n".getBytes(UTF_8));
        String shown = "working for 1 s; Ctrl-C stops it";
        String gone = "\r" + " ".repeat(shown.length()) + "\r";
        assertThat(terminal.toString(UTF_8))
                .isEqualTo(shown + gone + shown.replace('1', '2') + gone + "result\nmore\n");
    }

    @Test
    void elsewhereOneNoteIsPrintedAfterTwoSeconds() throws IOException {
        WorkingLine line = line(false);
        line.secondPassed();
        assertThat(terminal.size()).isZero();
        for (int second = 2; second < 100; second++) {
            line.secondPassed();
        }
        new WatchedStream(terminal, line).write("result\n".getBytes(UTF_8));
        assertThat(terminal.toString(UTF_8)).isEqualTo(WorkingLine.NOTE + System.lineSeparator() + "result\n");
    }

    @Test
    void onlyCommandsWithoutALineOfTheirOwnHaveIt() {
        for (String quiet : new String[] {"check", "explain", "trace", "measure"}) {
            assertThat(TompkinsCommand.isQuiet(quiet, "scene.json")).as(quiet).isTrue();
        }
        for (String other : new String[] {"render", "animate", "study", "help", "scene.json"}) {
            assertThat(TompkinsCommand.isQuiet(other, "check")).as(other).isFalse();
        }
        assertThat(TompkinsCommand.isQuiet()).isFalse();
    }
}
