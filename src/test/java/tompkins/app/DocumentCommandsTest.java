package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The commands that documents print with scenes of the program end without a mistake; here their pictures are tiny. */
class DocumentCommandsTest {

    private static final Pattern COMMAND = Pattern.compile("(?m)^ {4}tompkins (\\w+ .*scenes/[^#$\\n]*)");
    private static final Pattern WORD = Pattern.compile("\"([^\"]*)\"|'([^']*)'|(\\S+)");

    @TempDir
    private Path folder;

    static Stream<String> commands() throws IOException {
        List<Path> pages = new ArrayList<>(List.of(Path.of("README.md")));
        try (Stream<Path> documents = Files.list(Path.of("docs"))) {
            documents.filter(page -> page.toString().endsWith(".md")).sorted().forEach(pages::add);
        }
        List<String> commands = new ArrayList<>();
        for (Path page : pages) {
            String text = Files.readString(page).replaceAll("\\\\\\n +", "");
            COMMAND.matcher(text).results().map(found -> found.group(1)).forEach(commands::add);
        }
        return commands.stream().distinct();
    }

    @Test
    void documentsPrintCommands() throws IOException {
        assertThat(commands())
                .anyMatch(command -> command.startsWith("render "))
                .anyMatch(command -> command.startsWith("animate "))
                .anyMatch(command -> command.startsWith("trace "))
                .anyMatch(command -> command.startsWith("measure "))
                .hasSizeGreaterThan(20);
    }

    @ParameterizedTest
    @MethodSource("commands")
    void commandWorksAsPrinted(String command) throws IOException {
        List<String> words = words(command);
        ProgramRun run = ProgramRun.of(words.toArray());
        assertThat(run.code()).as(run.err()).isZero();
    }

    /** The arguments, with small pictures that go into the folder of the test. */
    private List<String> words(String command) throws IOException {
        List<String> printed = WORD.matcher(command)
                .results()
                .map(DocumentCommandsTest::unquoted)
                .toList();
        List<String> words = new ArrayList<>();
        for (int i = 0; i < printed.size(); i++) {
            String word = printed.get(i);
            switch (word) {
                case "-o" -> {
                    words.add(word);
                    words.add(output(printed.get(++i)));
                }
                case "--size", "--samples", "--duration" -> i++;
                default -> words.addAll(expanded(word));
            }
        }
        boolean takesPictures = List.of("render", "animate").contains(words.get(0));
        if (takesPictures || words.contains("all")) {
            words.addAll(List.of("--size", "16x12"));
        }
        if (takesPictures) {
            words.addAll(List.of("--samples", "1"));
            if (!words.contains("-o")) {
                words.addAll(List.of("-o", folder + "/"));
            }
        }
        if (words.get(0).equals("explain")) {
            // the forecast of a wanted error takes seconds
            words.addAll(List.of("--samples", "1"));
        }
        if (words.get(0).equals("animate")) {
            words.addAll(List.of("--duration", "0.1"));
        }
        return words;
    }

    private static String unquoted(MatchResult word) {
        return Stream.of(1, 2, 3)
                .map(word::group)
                .filter(Objects::nonNull)
                .findFirst()
                .orElseThrow();
    }

    /** A film needs no ffmpeg here. */
    private String output(String name) {
        String file = Path.of(name).getFileName().toString().replace(".mp4", ".gif");
        return folder.resolve(file) + (name.endsWith("/") ? "/" : "");
    }

    private static List<String> expanded(String word) throws IOException {
        if (!word.contains("*")) {
            return List.of(word);
        }
        Path pattern = Path.of(word);
        try (var files = Files.newDirectoryStream(
                pattern.getParent(), pattern.getFileName().toString())) {
            List<String> names = new ArrayList<>();
            files.forEach(file -> names.add(file.toString()));
            return names;
        }
    }
}
