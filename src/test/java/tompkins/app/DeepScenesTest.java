package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.OperatingSystemMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Whatever a scene file can nest is nested as deep as it may be: every command takes its time, not a power of it. */
@Tag("alone")
class DeepScenesTest {

    /** So many brackets and braces may be open at once. */
    private static final int DEEPEST = 200;

    /** Those around what is nested, and in what is innermost. */
    private static final int AROUND = 8;

    /** Processor time of all threads. */
    private static final double MOST_SECONDS = 30;

    private static final String BALL = "{'type': 'Sphere', 'centre': [0, 0, 10], 'radius': 3}";
    private static final String GREY = "{'type': 'ColouredSurface'}";
    private static final String READING = "{'type': 'RayReading', 'value': 'z'}";

    @TempDir
    private Path folder;

    /** Scenes, and what they nest. */
    private enum Deep {
        RESTING(
                "'scene'",
                Stream.of(
                        nest(BALL, 2, "{'type': 'Group', 'objects': [INNER]}"),
                        nest(BALL, 1, "{'type': 'Placed', 'rotationDegrees': 1, 'object': INNER}"))),
        COPIES(
                "'scene'",
                Stream.of(
                        nest(BALL, 1, "{'type': 'Hidden', 'object': INNER}"),
                        nest(
                                BALL,
                                1,
                                "{'type': 'ImagePointGrid', 'points': [1, 1], 'corner': [0, 0, 10], 'object': INNER}"))),
        MOVING(
                "'scene'",
                Stream.of(nest(
                        BALL,
                        2,
                        "{'type': 'Moving', 'velocity': [0, 0.01, 0], 'objects': [{'type': 'Sphere'}, INNER, {'type': 'Moving'}]}",
                        "{'type': 'Moving', 'velocity': [0.001, -0.01, 0], 'objects': [INNER, " + BALL + "]}"))),
        MIXED(
                "'scene'",
                Stream.of(nest(
                        BALL,
                        2,
                        "{'type': 'Group', 'objects': [INNER]}",
                        "{'type': 'Placed', 'rotationDegrees': 1, 'object': {'type': 'Placed', 'object': INNER}}",
                        "{'type': 'Moving', 'velocity': [0.01, 0.01, 0], 'objects': [INNER]}"))),
        LAMPS(
                "'scene': [" + BALL + "], 'lights'",
                Stream.of(nest(
                        "{'type': 'PointLight', 'position': [0, 5, 0]}",
                        2,
                        "{'type': 'Moving', 'velocity': [0.01, 0, 0], 'objects': [INNER]}"))),
        SURFACES(
                "'scene'",
                Stream.of(
                                nest(GREY, 1, "{'type': 'Tiling', 'first': INNER, 'second': {'type': 'Mirror'}}"),
                                nest(GREY, 1, "{'type': 'Blinking', 'first': INNER, 'second': {'type': 'Refractive'}}"),
                                nest(GREY, 1, "{'type': 'Clock', 'face': INNER, 'hand': {'type': 'Mirror'}}"),
                                nest(GREY, 1, "{'type': 'CutOut', 'dark': {'type': 'Clear'}, 'bright': INNER}"))
                        .map(surface -> BALL.replace("}", ", 'surface': " + surface + "}"))),
        MEASUREMENTS(
                "'scene': [" + BALL + "], 'lesson': {'type': 'Lesson', 'numbers'",
                Stream.of(
                                nest(
                                        READING,
                                        1,
                                        "{'type': 'DifferenceOf', 'first': INNER, 'second': {'type': 'RayReading'}}"),
                                nest(
                                        READING,
                                        1,
                                        "{'type': 'RatioOf', 'first': INNER, 'second': {'type': 'RayReading'}}"),
                                nest(READING, 1, "{'type': 'WithNumber', 'value': 1, 'measurement': INNER}"),
                                nest(READING, 1, "{'type': 'WithShutter', 'measurement': INNER}"))
                        .map(measurement -> "{'value': 7, 'tolerance': 1000, 'measurement': " + measurement + "}"));

        private final String key;
        private final List<String> parts;

        /** The parts are a list behind the key. */
        Deep(String key, Stream<String> parts) {
            this.key = key;
            this.parts = parts.toList();
        }

        /** Shells in each other, in turns, as many as fit; each opens so many brackets and braces around the next. */
        private static String nest(String innermost, int opened, String... shells) {
            StringBuilder before = new StringBuilder();
            StringBuilder after = new StringBuilder();
            for (int i = 0; i < (DEEPEST - AROUND) / opened; i++) {
                String[] halves = shells[i % shells.length].split("INNER");
                before.append(halves[0]);
                after.insert(0, halves[1]);
            }
            return before + innermost + after;
        }

        String scene() {
            String list = parts.stream().collect(Collectors.joining(", ", "[", "]"));
            String end = key.contains("lesson") ? "}}" : "}";
            return ("{'settings': {'width': 8, 'height': 6}, 'velocity': [0, 0, 0.1], " + key + ": " + list + end)
                    .replace('\'', '"');
        }
    }

    /** The first runs load the program. */
    @BeforeAll
    static void warmUp(@TempDir Path folder) {
        String lesson = "scenes/lesson-01-round-ball.json";
        assertThat(ProgramRun.of("check", lesson).code()).isZero();
        assertThat(ProgramRun.of("render", lesson, "--size", "8x6", "-o", folder.resolve("warm.png"))
                        .code())
                .isZero();
    }

    @ParameterizedTest
    @EnumSource
    void everyCommandIsQuick(Deep deep) throws IOException {
        Path scene = Files.writeString(folder.resolve("deep.json"), deep.scene());
        Path picture = folder.resolve("deep.png");
        assertQuick("check", scene);
        assertQuick("explain", scene);
        assertQuick("trace", scene, "--pixel", "all", "--json", "--set", "velocity.beta=0.2");
        assertQuick("measure", "between", scene, "--pixel", "4,3", "--pixel", "5,3");
        assertQuick("measure", "profile", scene, "--pixel", "4,3", "--pixel", "5,3");
        assertQuick("render", scene, "-o", picture);
        assertQuick(
                "animate",
                scene,
                "--from",
                "0.1",
                "--to",
                "0.5",
                "--duration",
                "0.1",
                "--fps",
                "10",
                "-o",
                folder.resolve("film"));
        if (deep == Deep.MEASUREMENTS) {
            assertQuick("measure", "lesson", scene);
        }
    }

    private static void assertQuick(Object... command) {
        double before = processorSeconds();
        ProgramRun run = ProgramRun.of(command);
        double seconds = processorSeconds() - before;

        assertThat(run.code()).as(run.err()).isZero();
        assertThat(seconds).as("%s", command[0]).isLessThan(MOST_SECONDS);
    }

    private static double processorSeconds() {
        return ((OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean()).getProcessCpuTime() / 1e9;
    }
}
