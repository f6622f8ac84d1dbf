package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvFileSource;
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

    private static final Map<String, String> PARTS = Map.of(
            "BALL", "{'type': 'Sphere', 'centre': [0, 0, 10], 'radius': 3}",
            "GREY", "{'type': 'ColouredSurface'}",
            "READING", "{'type': 'RayReading', 'value': 'z'}");

    @TempDir
    private Path folder;

    /** Shells in each other, in turns, as many as fit: each opens some brackets and braces around the next. */
    private static String scene(String around, String innermost, int opened, String shells, int depth) {
        String[] turns = shells.split(" ; ");
        String nested = innermost;
        for (int i = (depth - AROUND) / opened - 1; i >= 0; i--) {
            nested = turns[i % turns.length].replace("INNER", nested);
        }
        String scene = "{'settings': {'width': 8, 'height': 6}, 'velocity': [0, 0, 0.1], "
                + around.replace("INNER", nested) + "}";
        for (Map.Entry<String, String> part : PARTS.entrySet()) {
            scene = scene.replace(part.getKey(), part.getValue());
        }
        return scene.replace('\'', '"');
    }

    /** The shallow one comes first, which also loads the program. */
    @ParameterizedTest
    @CsvFileSource(resources = "deep-scenes.csv", delimiter = '|', quoteCharacter = '~')
    void everyCommandIsQuick(String around, String innermost, int opened, String shells) throws IOException {
        String whole = around.replace(
                "LESSON",
                "'scene': [BALL], 'lesson': {'type': 'Lesson',"
                        + " 'numbers': [{'value': 7, 'tolerance': 1000, 'measurement': INNER}]}");
        Path shallow = Files.writeString(
                folder.resolve("shallow.json"), scene(whole, innermost, opened, shells, DEEPEST / DEEPER));
        Path deepest = Files.writeString(folder.resolve("deep.json"), scene(whole, innermost, opened, shells, DEEPEST));
        List<String> commands = new ArrayList<>(List.of(
                "check SCENE",
                "explain SCENE",
                "trace SCENE --pixel all --json --set velocity.beta=0.2",
                "measure between SCENE --pixel 4,3 --pixel 5,3",
                "measure profile SCENE --pixel 4,3 --pixel 5,3",
                "render SCENE -o SCENE.png",
                "animate SCENE --from 0.1 --to 0.5 --duration 0.1 --fps 10 -o FILM"));
        if (around.equals("LESSON")) {
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
