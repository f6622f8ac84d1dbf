package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Measures before a wall in the distance 10, which a camera of 0.8 c meets straight ahead: D is 3 there. */
class MeasureCommandTest {

    @TempDir
    private Path folder;

    private Path scene;

    @BeforeEach
    void writeScene() throws IOException {
        scene = Files.writeString(folder.resolve("wall.json"), """
                {
                  "velocity": [0, 0, 0.8],
                  "camera": { "horizontalAngleDegrees": 90 },
                  "settings": { "width": 101, "height": 101 },
                  "scene": [{ "type": "Plane", "description": "wall, \\"white\\"", "point": [0, 0, 10],
                    "normal": [0, 0, -1], "surface": { "type": "LuminousSurface" } }]
                }
                """);
    }

    /** 50 columns beside the middle of 101 lies the slope 100/101. */
    private static double cameraAngle() {
        return Math.atan(100 / 101.0);
    }

    private static double sceneAngle() {
        return 2 * Math.atan(3 * Math.tan(cameraAngle() / 2));
    }

    @Test
    void anglesLengthsAndIntervalAreThoseOfTheFormulas() {
        Object[] both = {"measure", "between", scene, "--pixel", "50,50", "--pixel", "100,50"};
        String json = ProgramRun.of(List.of(both), "--json").out();
        String csv = ProgramRun.of(List.of(both), "--csv").out();
        String text = ProgramRun.of(both).out();

        // the ray at the edge of the picture goes back: it never meets the wall
        assertThat(Math.toDegrees(sceneAngle())).isGreaterThan(90);
        assertThat(value(json, "cameraAngle")).isCloseTo(Math.toDegrees(cameraAngle()), within(1e-12));
        assertThat(value(json, "sceneAngle")).isCloseTo(Math.toDegrees(sceneAngle()), within(1e-12));
        assertThat(json).doesNotContain("Distance", "Interval");
        assertThat(csv.lines().findFirst()).hasValue("quantity,value,uncertainty,unit");
        assertThat(csv).contains("cameraAngle,44.71").endsWith(",degrees\n");
        // half a pixel covers 0.567 degrees in the middle, and 0.403 in the row at the edge
        assertThat(text).containsPattern("angle \\(camera\\) +44\\.71 \\+- 0\\.70 degrees");

        Object[] near = {"measure", "between", scene, "--pixel", "50,50", "--pixel", "60,50", "--json"};
        String hits = ProgramRun.of(near).out();
        double angle = 2 * Math.atan(3 * Math.tan(Math.atan(20 / 101.0) / 2));
        double across = 10 * Math.tan(angle);
        double later = 10 - 10 / Math.cos(angle);
        assertThat(value(hits, "sceneDistance")).isCloseTo(across, within(1e-12));
        assertThat(value(hits, "sceneTime")).isCloseTo(later, within(1e-12));
        assertThat(value(hits, "objectDistance")).isCloseTo(across, within(1e-12));
        assertThat(value(hits, "sceneInterval")).isCloseTo(across * across - later * later, within(1e-11));
        assertThat(value(hits, "cameraInterval")).isCloseTo(across * across - later * later, within(1e-11));
        // half a column moves the hit by 10/cos^2 d tan(half)/da; both ends together
        assertThat(uncertainty(hits, "sceneDistance")).isBetween(0.15, 0.5);
        assertThat(uncertainty(hits, "cameraAngle"))
                .isCloseTo(Math.toDegrees(0.5 * Math.sqrt(2) * 2 / 101.0), within(0.03));
    }

    @Test
    void circlesAndLinesAreFitted() {
        Object[] circle = {"measure", "circle", scene, "--json", "--pixel", "60,50", "--pixel", "40,50", "--pixel"};
        String fitted = ProgramRun.of(List.of(circle), "50,60").out();
        assertThat(value(fitted, "halfAngle")).isCloseTo(Math.toDegrees(Math.atan(20 / 101.0)), within(1e-12));
        assertThat(value(fitted, "middlePixelX")).isCloseTo(50, within(1e-9));
        assertThat(value(fitted, "residual")).isCloseTo(0, within(1e-9));

        Object[] line = {"measure", "line", scene, "--json", "--pixel", "0,0", "--pixel", "50,50", "--pixel"};
        String straight = ProgramRun.of(List.of(line), "100,100").out();
        assertThat(value(straight, "largestMiss")).isCloseTo(0, within(1e-9));
        double length = 2 * Math.atan(Math.sqrt(2) * 100 / 101);
        assertThat(value(straight, "length")).isCloseTo(Math.toDegrees(length), within(1e-12));
        String bent = ProgramRun.of(List.of(line), "100,99").out();
        assertThat(value(bent, "largestMiss")).isGreaterThan(1.1 * value(bent, "residual"));
    }

    @Test
    void profilesAreTablesOfRays() {
        Object[] profile = {"measure", "profile", scene, "--pixel", "50,50", "--pixel", "54,50"};
        List<String> csv =
                ProgramRun.of(List.of(profile), "--csv").out().lines().toList();

        assertThat(csv).hasSize(6);
        assertThat(cell(csv, 1, "doppler_factor")).isEqualTo("3");
        assertThat(cell(csv, 1, "hit_scene_z [scene units]")).isEqualTo("10");
        assertThat(cell(csv, 5, "pixel_x [pixels]")).isEqualTo("54");
        assertThat(csv.get(1)).contains("\"wall, \"\"white\"\"\"");
        assertThat(ProgramRun.of(List.of(profile), "--json").out()).contains("\"hit_scene_z\": 10");
        List<String> text = ProgramRun.of(profile).out().lines().toList();
        assertThat(text.get(0)).matches("column +row +Doppler factor +object +time \\(scene\\) +red +green +blue");
        assertThat(text.get(1)).matches("50 +50 +3 +wall, \"white\" +-10 +1 +1 +1");
    }

    /** Rows are pixels, row by row; a ray that hits nothing has empty cells there, and its direction. */
    @Test
    void regionsAreTracedIntoTables() throws IOException {
        Path file = folder.resolve("rays.csv");
        ProgramRun run = ProgramRun.of("trace", scene, "--pixel", "all", "--every", "50", "--csv", "-o", file);

        assertThat(run.code()).as(run.err()).isZero();
        assertThat(run.out().strip()).isEqualTo(file.toAbsolutePath().toString());
        List<String> rows = Files.readAllLines(file);
        assertThat(rows).hasSize(10);
        assertThat(rows.stream().skip(1).map(row -> row.split(",")[0] + " " + row.split(",")[1]))
                .containsExactly("0 0", "50 0", "100 0", "0 50", "50 50", "100 50", "0 100", "50 100", "100 100");
        int middle = 5;
        assertThat(Double.parseDouble(cell(rows, middle, "camera_direction_z"))).isEqualTo(1);
        assertThat(cell(rows, middle, "distance [scene units]")).isEqualTo("10");
        assertThat(cell(rows, middle, "hit_camera_z [scene units]"))
                .startsWith("30.00000000")
                .hasSizeLessThan(19);
        assertThat(cell(rows, middle, "proper_time [scene units]")).isEqualTo("-10");
        assertThat(cell(rows, 1, "object")).isEmpty();
        assertThat(cell(rows, 1, "proper_time [scene units]")).isEmpty();
        double x = Double.parseDouble(cell(rows, 6, "scene_direction_x"));
        assertThat(x).isCloseTo(Math.sin(sceneAngle()), within(1e-15));

        ProgramRun again = ProgramRun.of("trace", scene, "--pixel", "1,1..2,2", "--csv", "-o", file);
        assertThat(again.code()).isEqualTo(2);
        assertThat(again.err()).contains("there is a file of this name already; --force replaces it");
        assertThat(Files.readAllLines(file)).isEqualTo(rows);
        ProgramRun forced = ProgramRun.of("trace", scene, "--pixel", "1,1..2,3", "--csv", "-o", file, "--force");
        assertThat(forced.code()).isZero();
        assertThat(Files.readAllLines(file)).hasSize(7);
    }

    /** sqrt(1.9/0.1) = 4.358899 straight ahead at 0.9 c; the second formula is wrong. */
    @Test
    void lessonsAreMeasured() throws IOException {
        Path lesson = Files.writeString(folder.resolve("lesson.json"), """
                {
                  "settings": { "width": 4, "height": 4 },
                  "lesson": { "control": { "measuredAt": 0.9 }, "numbers": [
                    { "name": "Ahead, \\"D\\"", "value": 4.359, "tolerance": 0.002 },
                    { "name": "Wrong", "value": 4, "tolerance": 0.002, "unit": "turns" } ] },
                  "scene": [{ "type": "Sphere", "centre": [0, 0, 10] }]
                }
                """);

        ProgramRun text = ProgramRun.of("measure", "lesson", lesson);
        List<String> csv = ProgramRun.of("measure", "lesson", lesson, "--csv")
                .out()
                .lines()
                .toList();
        String json = ProgramRun.of("measure", "lesson", lesson, "--json").out();

        assertThat(text.code()).isZero();
        assertThat(text.out().lines().map(line -> line.replaceAll(" {2,}", "|")))
                .containsExactly(
                        "number|formula|value|measured|allowed difference|agrees",
                        "Ahead, \"D\"|sqrt((1 + v)/(1 - v))|4.359|4.3589|0.002|yes",
                        "Wrong|sqrt((1 + v)/(1 - v))|4 turns|4.3589 turns|0.002|no");
        assertThat(csv.get(0)).isEqualTo("name,formula,value,measured,tolerance,agrees,unit");
        assertThat(csv.get(1))
                .startsWith("\"Ahead, \"\"D\"\"\",sqrt((1 + v)/(1 - v)),4.3590")
                .endsWith(",true,");
        assertThat(csv.get(2)).endsWith(",false,turns");
        assertThat(Double.parseDouble(csv.get(2).split(",")[3])).isCloseTo(Math.sqrt(19), within(1e-12));
        assertThat(json)
                .contains("\"agrees\": true")
                .contains("\"agrees\": false")
                .contains("\"unit\": \"turns\"");
        assertThat(ProgramRun.of("check", lesson).err())
                .contains("lesson.json:5:33: lesson.numbers[1].value: must be within 0.002");
    }

    /** The wall moves and its clock is ahead by 100: tau = t/gamma at its origin, and the clock shows 100 more. */
    @Test
    void tablesTellProperTimeAndClocksApart() throws IOException {
        Path clock = Files.writeString(folder.resolve("clock.json"), """
                {
                  "settings": { "width": 1, "height": 1 },
                  "scene": [{ "type": "Moving", "velocity": [0, 0, -0.6], "place": [0, 0, 8], "clockOffset": 100,
                    "objects": [{ "type": "Plane", "point": [0, 0, 0], "normal": [0, 0, 1] }] }]
                }
                """);
        List<String> rows = ProgramRun.of("trace", clock, "--pixel", "0,0", "--csv")
                .out()
                .lines()
                .toList();

        // 8 - 0.6 t = -t
        assertThat(Double.parseDouble(cell(rows, 1, "hit_scene_time [scene units]")))
                .isCloseTo(-20, within(1e-12));
        assertThat(Double.parseDouble(cell(rows, 1, "proper_time [scene units]")))
                .isCloseTo(-16, within(1e-12));
        assertThat(Double.parseDouble(cell(rows, 1, "clock_reading [scene units]")))
                .isCloseTo(84, within(1e-12));
    }

    private static String cell(List<String> rows, int row, String heading) {
        int column = Arrays.asList(rows.get(0).split(",")).indexOf(heading);
        // the name of the wall holds a comma
        return rows.get(row).replaceAll("\"[^,]*, [^,]*\"", "wall").split(",", -1)[column];
    }

    private static double value(String json, String key) {
        return number(json, key, "value");
    }

    private static double uncertainty(String json, String key) {
        return number(json, key, "uncertainty");
    }

    private static double number(String json, String key, String part) {
        Matcher matcher = Pattern.compile('"' + key + "\": \\{[^}]*\"" + part + "\": ([^,\\s}]*)")
                .matcher(json);
        assertThat(matcher.find()).as(json).isTrue();
        return Double.parseDouble(matcher.group(1));
    }
}
