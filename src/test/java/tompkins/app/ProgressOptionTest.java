package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.entry;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.json.JsonFactory;

/** What {@code --progress json} tells on the error stream, read by another parser. */
class ProgressOptionTest {

    @TempDir
    private Path folder;

    private Path scene;

    @BeforeEach
    void writeScene() throws IOException {
        scene = Files.writeString(folder.resolve("ball.json"), """
                {
                  "scene": [{ "type": "Sphere", "centre": [0, 0, 5], "radius": 1.5 }],
                  "settings": { "width": 32, "height": 24, "samples": 2 }
                }
                """);
    }

    private ProgramRun animate(Object... more) {
        return ProgramRun.of(
                List.of("animate", scene, "--from=0", "--to=0.9", "--duration=0.4", "--progress=json"), more);
    }

    /** The events of an error stream on which there is nothing else. */
    private static List<Map<String, Object>> events(ProgramRun run) {
        return run.err().lines().map(ProgressOptionTest::event).toList();
    }

    private static Map<String, Object> event(String line) {
        Map<String, Object> members = new LinkedHashMap<>();
        try (JsonParser parser = new JsonFactory().createParser(ObjectReadContext.empty(), line)) {
            assertThat(parser.nextToken()).as(line).isEqualTo(JsonToken.START_OBJECT);
            while (parser.nextToken() == JsonToken.PROPERTY_NAME) {
                String key = parser.currentName();
                boolean isText = parser.nextToken() == JsonToken.VALUE_STRING;
                members.put(key, isText ? parser.getString() : (Object) parser.getDoubleValue());
            }
            assertThat(parser.nextToken()).as(line).isNull();
        }
        return members;
    }

    private static List<Map<String, Object>> named(String name, ProgramRun run) {
        return events(run).stream()
                .filter(event -> event.get("event").equals(name))
                .toList();
    }

    @ParameterizedTest
    @ValueSource(strings = {"--error=0.02", "--samples=2"})
    void framesAreToldAsTheyComeAbout(String quality) {
        Path frames = folder.resolve("frames");
        ProgramRun first = animate("--frames=3", quality, "-o", frames);
        ProgramRun run = animate("--part=1/2", "--skip-existing", quality, "-o", frames);
        assertThat(first.code() + run.code()).as(run.err()).isZero();

        List<Map<String, Object>> told = named("frame", run);
        assertThat(told).extracting("frame").containsExactly(3.0, 1.0, 1.0, 5.0, 5.0, 7.0, 7.0, 9.0, 9.0);
        assertThat(told)
                .extracting("state")
                .startsWith("skipped", "begun", "done", "begun")
                .endsWith("begun", "done");
        for (Map<String, Object> frame : told) {
            assertThat(frame).contains(entry("of", 10.0));
            assertThat(frames.resolve(String.format(Locale.ROOT, "frame%04.0f.png", (Double) frame.get("frame"))))
                    .hasToString((String) frame.get("file"))
                    .isRegularFile();
            boolean isDone = frame.get("state").equals("done");
            assertThat(frame.containsKey("seconds")).isEqualTo(isDone);
            assertThat(frame.containsKey("error")).isEqualTo(isDone);
        }
    }

    @Test
    void framesOfOneFileAreToldWithoutFiles() {
        ProgramRun run = animate("-o", folder.resolve("film.gif"));
        assertThat(run.code()).as(run.err()).isZero();
        assertThat(named("frame", run))
                .hasSize(20)
                .allSatisfy(frame -> assertThat(frame).doesNotContainKey("file"));
    }

    @Test
    void picturesOfManyScenesAreTold() throws IOException {
        Path other = Files.copy(scene, folder.resolve("other.json"));
        String to = folder.resolve("out") + "/";
        assertThat(ProgramRun.of("render", other, "-o", to).code()).isZero();
        ProgramRun run = ProgramRun.of("render", scene, other, "-o", to, "--skip-existing", "--progress", "json");
        assertThat(events(run))
                .extracting(event -> List.of(event.get("event"), event.get("picture"), event.get("state")))
                .containsExactly(
                        List.of("picture", 0.0, "begun"),
                        List.of("picture", 0.0, "done"),
                        List.of("picture", 1.0, "skipped"));
        assertThat(events(run).get(1).get("file"))
                .isEqualTo(folder.resolve("out/ball.png").toString());
        assertThat((double) events(run).get(1).get("seconds")).isPositive();
    }

    /** The messages are those for people, which begin with the kind of the event. */
    @Test
    void whatIsSaidToPeopleIsToldAsEvents() throws IOException {
        Files.writeString(scene, """
                { "velocity": { "gamma": 10000000, "direction": [0, 0, 1] },
                  "settings": { "width": 8, "height": 6, "samples": 1 } }
                """);
        Path picture = folder.resolve("picture.png");
        ProgramRun plain = ProgramRun.of("render", scene, "-o", picture);
        ProgramRun told = ProgramRun.of("render", scene, "-o", picture, "--progress=json", "--force");
        assertThat(plain.err()).startsWith("warning: gamma 10000000");
        assertThat(named("warning", told).stream()
                        .map(event -> "warning: " + event.get("message"))
                        .toList())
                .containsExactlyElementsOf(plain.err().lines().toList());

        ProgramRun refused = ProgramRun.of("render", scene, "-o", picture, "--progress=json");
        assertThat(refused.code()).isEqualTo(2);
        assertThat(events(refused))
                .containsExactly(Map.of(
                        "event",
                        "error",
                        "message",
                        picture + ": there is a file of this name already; --force replaces it"));
    }

    @Test
    void namesInOtherLettersAreToldInAscii() throws IOException {
        Path strange = Files.copy(scene, folder.resolve("\u00e9\u2028\"\\\ud83d\ude80.json"));
        String to = folder.resolve("out") + "/";
        ProgramRun run = ProgramRun.of("render", strange, "-o", to, "--progress=json");
        assertThat(run.code()).isZero();
        assertThat(StandardCharsets.US_ASCII.newEncoder().canEncode(run.err())).isTrue();
        assertThat(named("picture", run))
                .extracting("file")
                .containsOnly(
                        folder.resolve("out/\u00e9\u2028\"\\\ud83d\ude80.png").toString());
    }

    @Test
    void trialsOfStudiesAreCounted() {
        ProgramRun run = ProgramRun.of("study", "depth", "-o", folder, "--progress=json", "--threads=1");
        assertThat(run.code()).as(run.err()).isZero();
        List<Map<String, Object>> trials = named("trial", run);
        assertThat(trials)
                .extracting("trial")
                .containsExactlyElementsOf(IntStream.range(0, trials.size())
                        .mapToObj(number -> (Object) (double) number)
                        .toList());
        assertThat(trials)
                .allSatisfy(trial -> assertThat(trial)
                        .contains(entry("of", (double) trials.size()), entry("study", "depth"))
                        .containsKeys("problem", "method", "setting"));
    }

    @Test
    void theShareIsToldAtMostOnceASecond() throws InterruptedException {
        StringWriter text = new StringWriter();
        ProgressReport report = ProgressReport.on(new JsonLines(new PrintWriter(text)));
        report.piece(1, 4);
        for (int i = 0; i < 1000; i++) {
            report.setProgress(0.5);
        }
        assertThat(text.toString()).isEmpty();
        Thread.sleep(1001);
        for (int i = 0; i < 1000; i++) {
            report.setProgress(0.5);
        }
        assertThat(event(text.toString())).isEqualTo(Map.of("event", "progress", "done", 0.375));
    }

    @Test
    void otherLanguagesAreRefused() {
        ProgramRun run = ProgramRun.of("render", scene, "--progress=xml");
        assertThat(run.code()).isEqualTo(2);
        assertThat(run.err()).contains("--progress must be json, was xml");
    }
}
