package tompkins.app;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;
import static org.junit.jupiter.params.provider.Arguments.arguments;
import static tompkins.app.ProgramRun.FIG1B;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

/** What belongs to no single command: words that mean nothing, the help, and the version. */
class TompkinsCommandTest {

    @Test
    void theVersionIsThatOfTheProject() throws IOException {
        Matcher project = Pattern.compile("<artifactId>tompkins</artifactId>\\s*<version>(.+)</version>")
                .matcher(Files.readString(Path.of("pom.xml")));
        assertThat(project.find()).isTrue();
        assertThat(ProgramRun.of("--version").out()).startsWith("Tompkins " + project.group(1) + "\n");
    }

    /** A command that is called is the only one that the program makes ready; the help makes all of them ready. */
    @ParameterizedTest
    @ValueSource(strings = {"render", "check", "explain", "trace", "measure", "sheet", "study"})
    void aCommandIsTheSameAloneAndAmongTheOthers(String command) {
        ProgramRun amongOthers = ProgramRun.of("help", command);

        assertThat(amongOthers.out())
                .contains("Usage: tompkins " + command + " ")
                .doesNotContain("<")
                .isEqualTo(ProgramRun.of(command, "--help").out());
        assertThat(amongOthers.code()).isZero();
    }

    @Test
    void helpIsACommandToo() {
        assertThat(ProgramRun.of("help").out())
                .isEqualTo(ProgramRun.of("--help").out());
        assertThat(ProgramRun.of("help", "render").out()).contains("--samples");
    }

    @Test
    void helpTellsTheKeysOfATypeToo() {
        ProgramRun run = ProgramRun.of("help", "sphere");
        assertThat(run.code()).isZero();
        assertThat(run.out().lines())
                .startsWith(
                        "Sphere (SceneObject)",
                        "  A sphere; u runs once around its vertical axis, from left to right seen from")
                .containsSequence(
                        "  radius         Radius", "                 a finite number above 0; unit: length; default: 1")
                .contains("    {\"type\": \"Sphere\", \"centre\": [0, 0, 10], \"radius\": 1}");
        assertThat(ProgramRun.of("help", "Surface").out().lines())
                .contains("  Mirror                  A mirror on both sides")
                .hasSizeGreaterThan(18);
        assertThat(ProgramRun.of("help", "moving").out()).contains("Moving (SceneObject)\n", "Moving (LightSource)\n");
    }

    /** A terminal of 80 columns and 24 rows shows it with the line of the next command. */
    @Test
    void helpFitsOnOneScreen() {
        String help = ProgramRun.of("help").out();
        assertThat(help.lines()).hasSizeLessThan(24).allMatch(line -> line.length() <= 80);
        assertThat(TompkinsCommand.withAllCommands().getSubcommands().keySet())
                .allSatisfy(name -> assertThat(help).containsPattern("(?m)^  " + name + " +[A-Z].*\\.$"));
    }

    /** Bash itself completes by the script. */
    @Test
    void completionKnowsCommandsAndOptions(@TempDir Path folder) throws IOException, InterruptedException {
        ProgramRun run = ProgramRun.of("completion");
        assertThat(run.code()).isZero();
        assumeTrue(Files.isExecutable(Path.of("/bin/bash")), "no bash");
        Files.writeString(folder.resolve("script"), run.out());
        String complete = ". ./script; complete -p tompkins;"
                + " for words in 'tompkins re' 'tompkins trace --pu' 'tompkins study prec'; do"
                + " COMP_WORDS=($words); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); COMPREPLY=();"
                + " _complete_tompkins; echo \"${COMPREPLY[*]}\"; done";
        Process bash = new ProcessBuilder("/bin/bash", "-c", complete)
                .directory(folder.toFile())
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
        String out = new String(bash.getInputStream().readAllBytes(), UTF_8);
        bash.waitFor();
        assertThat(out.lines()).hasSize(4).endsWith("render", "--pupil", "precision");
    }

    private static Stream<Arguments> optionsWithValues() {
        CommandLine program = TompkinsCommand.withAllCommands();
        return program.getSubcommands().entrySet().stream()
                .flatMap(command -> command.getValue().getCommandSpec().options().stream()
                        .filter(option -> option.arity().max() > 0)
                        .map(option -> arguments(command.getKey(), option.longestName(), option.type())));
    }

    @ParameterizedTest
    @MethodSource("optionsWithValues")
    void aWrongValueIsShownWithWhatIsAllowed(String command, String option, Class<?> type) {
        for (String value : new String[] {"x", "2.5x", "1e", "0x10"}) {
            ProgramRun run = ProgramRun.of(command, FIG1B, option + "=" + value);
            assertThat(run.err()).as(value).doesNotContain("Invalid value", "Exception", "not a", "should be");
            if (type != String.class && type != Path.class && type != List.class) {
                assertThat(run.code()).as(value).isEqualTo(Failures.MISTAKE);
                assertThat(run.err()).as(value).contains(option + " must be ").contains(", was " + value);
            }
        }
    }

    @ParameterizedTest
    @CsvSource({
        "'',             true",
        "scene.json,     true",
        "help,           false",
        "render,         false",
        "--version,      false",
        "check a.json,   false"
    })
    void tellsAtOnceWhetherAWindowWillOpen(String line, boolean window) {
        String[] words = line.isEmpty() ? new String[0] : line.split(" ");
        assertThat(TompkinsCommand.opensWindow(words)).isEqualTo(window);
    }
}
