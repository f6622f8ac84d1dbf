package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.zip.CRC32;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tompkins.GeneratedDocument;
import tompkins.OnLinux;

/**
 * Every kind of bad input, what the program says, and that it says no more than that. The table stands in
 * {@code src/test/resources/tompkins/app/messages.md}; {@code mvn -q test -Dtest=LimitsTest -Dtompkins.regenerate=true}
 * writes it again.
 */
@OnLinux
class LimitsTest {

    private static final String BEGIN = "<!-- generated: LimitsTest -->\n";

    @TempDir
    private Path folder;

    private record Case(String what, int code, String... words) {}

    @Test
    void everyBadInputGetsTheMessageOfTheTable() throws IOException {
        Path document = GeneratedDocument.resource("tompkins/app/messages.md");
        String old = Files.exists(document) ? Files.readString(document).replace("\r\n", "\n") : BEGIN;
        StringBuilder table = new StringBuilder(old.substring(0, old.indexOf(BEGIN) + BEGIN.length()));
        table.append("\n| bad input | exit code | message |\n|---|---|---|\n");
        for (Case bad : cases()) {
            ProgramRun run = ProgramRun.of((Object[]) bad.words);
            assertThat(run.code()).as("%s: %s", bad.what, run.err()).isEqualTo(bad.code);
            assertThat(run.out().isEmpty()).as(bad.what).isEqualTo(bad.code != 0);
            assertThat(run.err()).as(bad.what).isNotBlank().doesNotContain("Exception", "\tat ");
            String message = run.err()
                    .strip()
                    .replace(folder + "/", "")
                    .replace(folder.toString(), "the folder")
                    .replace("|", "\\|");
            table.append("| ")
                    .append(bad.what)
                    .append(" | ")
                    .append(bad.code)
                    .append(" | ")
                    .append(message.lines()
                            .map(line -> "`" + line + "`")
                            .reduce((a, b) -> a + "<br>" + b)
                            .orElseThrow())
                    .append(" |\n");
        }
        Files.delete(folder.resolve("link.png.txt"));
        GeneratedDocument.assertUpToDate(document, table.toString(), getClass());
        assertThat(Files.readString(folder.resolve("mine.png"))).isEqualTo("mine");
        try (var files = Files.list(folder)) {
            assertThat(files.filter(file -> file.toString().endsWith(".png"))
                            .map(file -> file.getFileName().toString()))
                    .containsExactlyInAnyOrder(
                            "mine.png", "text.png", "bomb.png", "folder.png", "cut.png", "damaged.png");
        }
    }

    private String[] animate(String scene, String... more) {
        String output = folder.resolve("never.gif").toString();
        List<String> words = new ArrayList<>(List.of("animate", scene, "--from", "0", "--to", "1", "-o", output));
        words.addAll(List.of(more));
        return words.toArray(String[]::new);
    }

    private static String[] film(String scene, String output, String... more) {
        List<String> words = new ArrayList<>(List.of("animate", scene, "--from", "0", "--to", "0.9", "-o", output));
        words.addAll(List.of(more));
        return words.toArray(String[]::new);
    }

    private List<Case> cases() throws IOException {
        write("text.png", "this is no picture");
        Files.write(folder.resolve("bomb.png"), pictureThatClaims(100_000, 100_000));
        write("mine.png", "mine");
        Files.createDirectories(folder.resolve("folder.png"));
        Files.createSymbolicLink(
                folder.resolve("link.png.txt"), Path.of("README.md").toAbsolutePath());
        String good = write("good.json", "{ \"scene\": [{ \"type\": \"Sphere\" }] }");
        String output = folder.resolve("never.png").toString();
        return List.of(
                scene("speed of light", "{ \"velocity\": [0, 0, 1] }"),
                scene("faster than light by rounding only", "{ \"velocity\": [0.6, 0.8, 0] }"),
                scene("gamma beyond what doubles hold", "{ \"velocity\": { \"gamma\": 1e9 } }"),
                new Case(
                        "gamma above the guaranteed accuracy",
                        0,
                        "check",
                        write("fast.json", "{ \"velocity\": { \"gamma\": 1e7 } }")),
                scene("NaN", "{ \"velocity\": [0, 0, NaN] }"),
                scene("Infinity", "{ \"camera\": { \"apertureRadius\": Infinity } }"),
                scene("number too large for a double", "{ \"camera\": { \"apertureRadius\": 1e999 } }"),
                scene("misspelt key", "{ \"camera\": { \"aperturRadius\": 0.1 } }"),
                scene("key in the wrong place", "{ \"camera\": { \"openingTime\": 1 } }"),
                scene("missing type", "{ \"scene\": [{ \"radius\": 1 }] }"),
                scene("misspelt type", "{ \"scene\": [{ \"type\": \"Spere\" }] }"),
                scene("wrong kind of value", "{ \"scene\": [{ \"type\": \"Sphere\", \"radius\": \"big\" }] }"),
                scene("too few numbers", "{ \"scene\": [{ \"type\": \"Sphere\", \"centre\": [1, 2] }] }"),
                scene("key given twice", "{ \"title\": \"a\", \"title\": \"b\" }"),
                scene("several mistakes", "{ \"velocity\": [2, 0, 0],\n  \"camera\": { \"exposureStop\": 1 } }"),
                scene("zero radius", "{ \"scene\": [{ \"type\": \"Sphere\", \"radius\": 0 }] }"),
                scene("negative radius", "{ \"scene\": [{ \"type\": \"Disc\", \"radius\": -1 }] }"),
                scene(
                        "degenerate triangle",
                        "{ \"scene\": [{ \"type\": \"Triangle\", \"first\": [0, 0, 1], \"second\": [1, 0, 1],"
                                + " \"third\": [2, 0, 1] }] }"),
                scene(
                        "focus through the lens",
                        "{ \"camera\": { \"focus\": { \"type\": \"Plane\", \"point\": [0, 0, 0] } } }"),
                scene("shutter that closes before it opens", "{ \"camera\": { \"exposureTime\": -1 } }"),
                scene("shutter that rolls backwards", "{ \"camera\": { \"rollingShutter\": { \"sweep\": -2 } } }"),
                scene(
                        "shutter that rolls in no direction",
                        "{ \"camera\": { \"rollingShutter\": { \"direction\": \"downwards\", \"sweep\": 2 } } }"),
                scene("eyes too far apart", "{ \"camera\": { \"stereo\": { \"eyeDistance\": 30 } } }"),
                scene("unknown layout of two eyes", "{ \"camera\": { \"stereo\": { \"layout\": \"crossed\" } } }"),
                scene(
                        "panorama with two eyes and another shutter",
                        "{ \"camera\": { \"type\": \"PanoramicCamera\", \"stereo\": { \"layout\": \"anaglyph\" },"
                                + " \"shutter\": { \"type\": \"FocusSurfaceShutter\" } } }"),
                scene("lesson without a right answer", "{ \"lesson\": { \"right\": 3 } }"),
                scene("lesson without a choice", "{ \"lesson\": { \"predictions\": [{ \"text\": \"Yes.\" }] } }"),
                scene("lesson that asks nothing", "{ \"lesson\": { \"question\": \"\" } }"),
                scene("lesson that explains too much", "{ \"lesson\": { \"reveal\": \"" + "so ".repeat(200) + "\" } }"),
                lesson("lesson that moves nothing", "\"control\": { \"number\": \"velocity.bta\" }"),
                lesson("lesson that moves what the scene has not", "\"control\": { \"number\": \"scene[0].radius\" }"),
                lesson("lesson that goes beyond the speed of light", "\"control\": { \"to\": 1.1 }"),
                lesson(
                        "lesson that is measured beyond its slider",
                        "\"control\": { \"to\": 0.5, \"measuredAt\": 0.9 }"),
                measuring("point outside the picture", "{ \"type\": \"RayReading\", \"point\": { \"across\": 1.5 } }"),
                measuring("unknown measurement", "{ \"type\": \"Angle\" }"),
                measuring(
                        "edge that is not there",
                        "{ \"type\": \"RayReading\", \"point\": { \"type\": \"PictureEdge\", \"count\": 9 } }"),
                measuring("place of nothing", "{ \"type\": \"RayReading\", \"value\": \"x\" }"),
                measuring("formula that is wrong", "{ \"type\": \"CircleRadius\" }"),
                scene(
                        "object as fast as light",
                        "{ \"scene\": [{ \"type\": \"Moving\", \"velocity\": [0.6, 0.8, 0] }] }"),
                scene(
                        "object beyond the largest gamma",
                        "{ \"scene\": [{ \"type\": \"Moving\", \"velocity\": { \"gamma\": 1e9 } }] }"),
                scene(
                        "motion in motion beyond the largest gamma",
                        "{ \"scene\": [{ \"type\": \"Moving\", \"velocity\": { \"gamma\": 1e5 }, \"objects\":"
                                + " [{ \"type\": \"Moving\", \"velocity\": { \"gamma\": 1e4 } }] }] }"),
                new Case(
                        "object above the guaranteed accuracy",
                        0,
                        "check",
                        write(
                                "fast-object.json",
                                "{ \"scene\": [{ \"type\": \"Moving\", \"velocity\": { \"gamma\": 1e7 } }] }")),
                scene(
                        "lamp as fast as light",
                        "{ \"lights\": [{ \"type\": \"Moving\", \"velocity\": [0, -1, 0], \"objects\": [] }] }"),
                scene(
                        "flash of no duration",
                        "{ \"lights\": [{ \"type\": \"PointLight\", \"flash\": { \"duration\": 0 } }] }"),
                scene(
                        "flashes that overlap",
                        "{ \"lights\": [{ \"type\": \"PointLight\", \"flash\": { \"duration\": 2, \"period\": 1 } }] }"),
                scene(
                        "lamp in motion in motion beyond the largest gamma",
                        "{ \"lights\": [{ \"type\": \"Moving\", \"velocity\": { \"gamma\": 1e5 }, \"objects\":"
                                + " [{ \"type\": \"Moving\", \"velocity\": { \"gamma\": 1e4 } }] }] }"),
                scene("more velocities than are searched", velocities(257)),
                scene(
                        "object that moves, before the lens",
                        "{ \"cameraFrame\": [{ \"type\": \"Group\", \"objects\": [{ \"type\": \"Moving\" }] }] }"),
                scene("wheel that is too fast", "{ \"scene\": [{ \"type\": \"Rotating\", \"angularSpeed\": 1 }] }"),
                scene(
                        "wheel that is endless",
                        "{ \"scene\": [{ \"type\": \"Rotating\", \"objects\": [{ \"type\": \"Plane\" }] }] }"),
                scene(
                        "wheel in a wheel",
                        "{ \"scene\": [{ \"type\": \"Rotating\", \"objects\": [{ \"type\": \"Rotating\" }] }] }"),
                scene("lamp that turns", "{ \"lights\": [{ \"type\": \"Rotating\", \"objects\": [] }] }"),
                scene("object that moves, in focus", "{ \"camera\": { \"focus\": { \"type\": \"Moving\" } } }"),
                scene(
                        "clock offset that is infinite",
                        "{ \"scene\": [{ \"type\": \"Moving\", \"clockOffset\": Infinity }] }"),
                scene("unknown view", "{ \"view\": \"looked at\" }"),
                scene("empty file", ""),
                scene("file of another kind", "# Notes\n\nA camera moves."),
                scene("number as in other languages", "{ \"camera\": { \"apertureRadius\": .5 } }"),
                scene("file that ends too early", "{ \"title\": \"a\""),
                scene("comma that is missing", "{\n\"title\": \"a\"\n\"topic\": \"b\" }"),
                scene("key without quotes", "{ title: \"a\" }"),
                scene("quote that is missing", "{ \"title\": \"a\n}"),
                scene("path of Windows", "{ \"title\": \"C:\\data\" }"),
                scene("code for a terminal", "{ \"title\": \"\u001b[31mred\" }"),
                new Case("scene in UTF-16", 2, "check", utf16()),
                scene("nesting", "[".repeat(100_000)),
                new Case("100 MB of nesting", 2, "check", large()),
                new Case("photograph that is cut", 2, "check", cutPhotograph(good)),
                new Case("photograph that is damaged", 2, "check", damagedPhotograph(good)),
                scene("file that is not a picture", surface("text.png")),
                scene("picture that claims 100000 x 100000", surface("bomb.png")),
                scene("picture outside the scene's folder", surface("../other.png")),
                scene("picture with an absolute path", surface("/etc/hostname")),
                scene("picture behind a link that leads out", surface("link.png.txt")),
                scene("picture that is missing", surface("nothing.png")),
                scene(
                        "object beyond all numbers",
                        "{ \"scene\": [{ \"type\": \"Sphere\" }, { \"type\": \"Cone\", \"tip\": [-1e308, 0, 5],"
                                + " \"baseCentre\": [1e308, 0, 5] }] }"),
                scene(
                        "copies of copies",
                        "{ \"scene\": [{ \"type\": \"ImagePointGrid\", \"points\": [1000, 1000], \"object\":"
                                + " { \"type\": \"ImagePointGrid\", \"points\": [30, 30] } }] }"),
                scene("TIFF picture with another compression", surface(foreign("tiff-zstd.tif"))),
                scene("TIFF picture with signed numbers", surface(foreign("tiff-int8.tif"))),
                scene("Radiance picture with other colours", surface(foreign("hdr-xyze.hdr"))),
                new Case(
                        "missing scene file",
                        2,
                        "render",
                        folder.resolve("nothing.json").toString()),
                new Case("picture too large", 2, "render", good, "-o", output, "--size", "60000x60000"),
                new Case("picture with no pixels", 2, "render", good, "-o", output, "--size", "0x10"),
                new Case(
                        "existing output",
                        2,
                        "render",
                        good,
                        "-o",
                        folder.resolve("mine.png").toString()),
                new Case(
                        "output with another ending",
                        2,
                        "render",
                        good,
                        "-o",
                        folder.resolve("a.bmp").toString()),
                new Case(
                        "output in a missing folder",
                        2,
                        "render",
                        good,
                        "--size",
                        "8x6",
                        "-o",
                        folder.resolve("no/a.png").toString()),
                new Case("samples option", 2, "render", good, "-o", output, "--samples", "0"),
                new Case("error option", 2, "render", good, "-o", output, "--error", "2"),
                new Case("animation of what is no number", 2, animate(good, "--number", "scene[0].centre")),
                new Case("animation beyond the speed of light", 2, animate(good)),
                new Case("animation of a number that is given, too", 2, film(good, "a.gif", "--beta", "0.3")),
                new Case("animation in a picture's format", 2, film(good, "a.png")),
                new Case("part that there is not", 2, film(good, "frames", "--part", "4/4")),
                new Case("part of a film in a file", 2, film(good, "a.gif", "--part", "0/4")),
                new Case("two wishes at once", 2, "render", good, "-o", output, "--samples", "4", "--seconds", "1"),
                new Case("option without its number", 2, "render", "--error", good),
                new Case("option before its command", 2, "--samples", "4", good),
                new Case("velocity option", 2, "render", good, "-o", output, "--beta", "0,0,2"),
                new Case("speed option", 2, "render", good, "-o", output, "--beta", "1.2"),
                new Case("Lorentz factor option", 2, "render", good, "-o", output, "--gamma", "0.9"),
                new Case("two velocities", 2, "render", good, "-o", output, "--beta", "0,0,0.5", "--gamma", "2"),
                new Case("unknown option", 2, "render", good, "-o", output, "--bta", "0,0,2"),
                new Case("unknown shutter", 2, "render", good, "-o", output, "--set", "camera.shutter.type=Rolling"),
                new Case("key of a scene as an option", 2, "render", good, "-o", output, "--sweep", "4"),
                new Case("key that is set and is none", 2, "check", good, "--set", "settings.widht=9"),
                new Case("no pixel", 2, "trace", good),
                new Case("pixel outside the picture", 2, "trace", good, "--pixel", "640,0"),
                new Case("part of a pixel", 2, "trace", good, "--pixel", "1.5,2"),
                new Case("rectangle upside down", 2, "trace", good, "--pixel", "9,9..3,3", "--csv"),
                new Case("table and JSON", 2, "trace", good, "--pixel", "9,9", "--csv", "--json"),
                new Case("nothing to measure", 2, "measure", "angle", good, "--pixel", "9,9"),
                new Case("two pixels for a circle", 2, "measure", "circle", good, "--pixel", "9,9", "--pixel", "3,3"),
                new Case("place outside the picture", 2, "measure", "line", good, "--pixel", "9,9", "--pixel", "640,3"),
                new Case("no study", 2, "study"),
                new Case("neither command nor scene", 2, "rendr"));
    }

    private static String velocities(int count) {
        return IntStream.range(0, count)
                .mapToObj(i -> "{ \"type\": \"Moving\", \"velocity\": [0, 0, " + (i + 1) / 1000.0 + "] }")
                .collect(Collectors.joining(", ", "{ \"scene\": [", "] }"));
    }

    private int count;

    private Case scene(String what, String text) throws IOException {
        return new Case(what, 2, "check", write("scene-" + ++count + ".json", text));
    }

    private Case lesson(String what, String part) throws IOException {
        return scene(what, "{ \"lesson\": { " + part + " } }");
    }

    private Case measuring(String what, String measurement) throws IOException {
        return scene(
                what,
                "{ \"lesson\": { \"numbers\": [{ \"measurement\": " + measurement + " }] },"
                        + (what.startsWith("place")
                                ? ""
                                : " \"scene\": [{ \"type\": \"Sphere\", \"centre\": [0, 0, 5] }],")
                        + " \"title\": \"a lesson\" }");
    }

    private static String surface(String picture) {
        return "{ \"scene\": [{ \"type\": \"Sphere\", \"surface\": { \"type\": \"PictureSurface\", \"picture\": \""
                + picture + "\" } }] }";
    }

    /** A picture of another program, beside the scene. */
    private String foreign(String name) throws IOException {
        Files.copy(Path.of("src", "test", "resources", "pictures", name), folder.resolve(name));
        return name;
    }

    private String write(String name, String text) throws IOException {
        return Files.writeString(folder.resolve(name), text).toString();
    }

    private String utf16() throws IOException {
        return Files.write(folder.resolve("utf16.json"), "{}".getBytes(StandardCharsets.UTF_16))
                .toString();
    }

    private String large() throws IOException {
        byte[] brackets = new byte[100 << 20];
        Arrays.fill(brackets, (byte) '[');
        return Files.write(folder.resolve("large.json"), brackets).toString();
    }

    private String cutPhotograph(String scene) throws IOException {
        Path photograph = folder.resolve("cut.png");
        ProgramRun.of("render", scene, "-o", photograph, "--size", "64x48");
        byte[] whole = Files.readAllBytes(photograph);
        return Files.write(photograph, Arrays.copyOf(whole, whole.length - 500)).toString();
    }

    private String damagedPhotograph(String scene) throws IOException {
        Path photograph = folder.resolve("damaged.png");
        ProgramRun.of("render", scene, "-o", photograph, "--size", "64x48");
        byte[] bytes = Files.readAllBytes(photograph);
        // the length of the header
        bytes[8] ^= (byte) 0x80;
        return Files.write(photograph, bytes).toString();
    }

    /** The beginning of a PNG file with a sound header. */
    private static byte[] pictureThatClaims(int width, int height) throws IOException {
        var bytes = new ByteArrayOutputStream();
        var out = new DataOutputStream(bytes);
        var header = new ByteArrayOutputStream();
        var headerOut = new DataOutputStream(header);
        headerOut.write("IHDR".getBytes(StandardCharsets.US_ASCII));
        headerOut.writeInt(width);
        headerOut.writeInt(height);
        headerOut.write(new byte[] {8, 2, 0, 0, 0});
        CRC32 sum = new CRC32();
        sum.update(header.toByteArray());
        out.writeLong(0x89504e470d0a1a0aL);
        out.writeInt(13);
        out.write(header.toByteArray());
        out.writeInt((int) sum.getValue());
        return bytes.toByteArray();
    }
}
