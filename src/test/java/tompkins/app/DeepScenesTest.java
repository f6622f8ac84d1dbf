package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import tompkins.ProcessorTime;
import tompkins.Thorough;

/** Whatever a scene file can nest is nested as deep as it may be: every command takes its time, not a power of it. */
@Thorough
class DeepScenesTest {

    /** So many brackets and braces may be open at once. */
    private static final int DEEPEST = 200;

    /** Those around what is nested, and in what is innermost. */
    private static final int AROUND = 8;

    /** So many times deeper than in the scene whose time is compared. */
    private static final int DEEPER = 4;

    /** The most processor time that a command may take then, in times of that scene: little more than the square. */
    private static final double MOST = 1.5 * DEEPER * DEEPER;

    /** So many seconds of the processor are nothing. */
    private static final double NOTHING = 0.05;

    private static final String BALL = "{'type': 'Sphere', 'centre': [0, 0, 10], 'radius': 3}";
    private static final String GREY = "{'type': 'ColouredSurface'}";
    private static final String READING = "{'type': 'RayReading', 'value': 'z'}";

    @TempDir
    private Path folder;

    /**
     * Shells in each other, in turns, as many as fit.
     *
     * @param opened how many brackets and braces each opens around the next
     * @param around what stands before and behind all of them
     */
    private record Nest(String innermost, int opened, List<String> shells, String around) {

        String text(int depth) {
            String text = innermost;
            for (int i = (depth - AROUND) / opened - 1; i >= 0; i--) {
                text = shells.get(i % shells.size()).replace("INNER", text);
            }
            return around.replace("INNER", text);
        }

        Nest in(String other) {
            return new Nest(innermost, opened, shells, other);
        }
    }

    private static Nest nest(String innermost, int opened, String... shells) {
        return new Nest(innermost, opened, List.of(shells), "INNER");
    }

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
                        .map(surface -> surface.in(BALL.replace("}", ", 'surface': INNER}")))),
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
                        .map(measurement -> measurement.in("{'value': 7, 'tolerance': 1000, 'measurement': INNER}")));

        private final String key;
        private final List<Nest> parts;

        /** The parts are a list behind the key. */
        Deep(String key, Stream<Nest> parts) {
            this.key = key;
            this.parts = parts.toList();
        }

        String scene(int depth) {
            String list = parts.stream().map(part -> part.text(depth)).collect(Collectors.joining(", ", "[", "]"));
            String end = key.contains("lesson") ? "}}" : "}";
            return ("{'settings': {'width': 8, 'height': 6}, 'velocity': [0, 0, 0.1], " + key + ": " + list + end)
                    .replace('\'', '"');
        }
    }

    /** The shallow one comes first, which also loads the program. */
    @ParameterizedTest
    @EnumSource
    void everyCommandIsQuick(Deep deep) throws IOException {
        Path shallow = Files.writeString(folder.resolve("shallow.json"), deep.scene(DEEPEST / DEEPER));
        Path deepest = Files.writeString(folder.resolve("deep.json"), deep.scene(DEEPEST));
        List<String> commands = new ArrayList<>(List.of(
                "check SCENE",
                "explain SCENE",
                "trace SCENE --pixel all --json --set velocity.beta=0.2",
                "measure between SCENE --pixel 4,3 --pixel 5,3",
                "measure profile SCENE --pixel 4,3 --pixel 5,3",
                "render SCENE -o SCENE.png",
                "animate SCENE --from 0.1 --to 0.5 --duration 0.1 --fps 10 -o FILM"));
        if (deep == Deep.MEASUREMENTS) {
            commands.add("measure lesson SCENE");
        }
        for (String command : commands) {
            double usual = seconds(command, shallow);
            assertThat(seconds(command, deepest) / Math.max(usual, NOTHING))
                    .as(command)
                    .isLessThan(MOST);
        }
    }

    private static double seconds(String command, Path scene) {
        return ProcessorTime.ofProcess(() -> {
            ProgramRun run = ProgramRun.of((Object[]) command.replace("SCENE", scene.toString())
                    .replace("FILM", scene.toString().replace(".json", "-film"))
                    .split(" "));
            assertThat(run.code()).as(run.err()).isZero();
        });
    }
}
