package tompkins.lab;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.jar.Attributes;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tompkins.RunningJava;
import tompkins.image.PhotographFile;
import tompkins.io.SelfDescription;

/** Types of another jar: those that {@code docs/extending.md} shows, and wrong ones. */
class ExtensionTest {

    private static final String SURFACE = "surface.AddedSurface";
    private static final Pattern PROGRAM = Pattern.compile("```java\n(.*?)```", Pattern.DOTALL);

    /** A grating before a wall, and a lens whose edge the iris delays. */
    private static final String GRATING = """
            {"velocity": [0, 0, SPEED], "settings": {"width": 40, "height": 30},
             "camera": {"apertureRadius": 0.5, "shutter": {"type": "IrisShutter", "openingTime": 3}},
             "scene": [
                {"type": "Parallelogram", "corner": [-9, -9, 4], "spanU": [18, 0, 0], "spanV": [0, 18, 0],
                 "surface": {"type": "Grating", "orders": 0.2}},
                {"type": "Plane", "point": [0, 0, 9], "normal": [0, 0, -1]}]}""";

    /** A torus of air before a wall, so that a ray meets all of it. */
    private static final String TORUS = """
            {"settings": {"width": 40, "height": 30},
             "scene": [
                {"type": "Torus", "centre": [ASIDE, 0, 10], "axis": [AXIS], "radius": 2, "tubeRadius": 0.5,
                 "surface": {"type": "Clear"}},
                {"type": "Plane", "point": [0, 0, 20], "normal": [0, 0, -1]}]}""";

    /** The beginning of what turns about the axis of the torus beside the camera. */
    private static final String TURNING = "{\"type\": \"Rotating\", \"centre\": [2, 0, 10], \"axis\": [0, 0, 1],"
            + " \"angularSpeed\": 0.3, \"objects\": [{\"type\": \"Torus\"";

    @TempDir
    private static Path folder;

    private static Path jar;

    private record Run(int code, String out) {}

    @BeforeAll
    static void makeJar() throws IOException {
        Matcher page = PROGRAM.matcher(Files.readString(Path.of("docs/extending.md")));
        assertThat(page.find()).isTrue();
        List<String> sources = new ArrayList<>(List.of(page.group(1)));
        for (String name : List.of("IrisShutter", "Torus", "TorusShape")) {
            sources.add(Files.readString(Path.of("src/test/java/optics/" + name + ".java")));
        }
        jar = jar(
                "optics",
                sources,
                "surface.AddedSurface",
                "Grating",
                "shutter.AddedShutter",
                "IrisShutter",
                "sceneobject.AddedObject",
                "Torus");
    }

    /** A jar of records in the package {@code optics}, with a file for each service that names one of them. */
    private static Path jar(String name, List<String> sources, String... services) throws IOException {
        Path classes = Files.createDirectories(folder.resolve(name + "-classes"));
        List<String> arguments =
                new ArrayList<>(List.of("-cp", RunningJava.CLASS_PATH, "-proc:none", "-d", classes.toString()));
        for (String source : sources) {
            Matcher record = Pattern.compile("(?m)^(?:.*;)?(?: ?public| ?final)* (?:record|class) (\\w+)")
                    .matcher(source);
            assertThat(record.find()).isTrue();
            Path file = Files.createDirectories(folder.resolve(name)).resolve(record.group(1) + ".java");
            Files.writeString(file, source);
            arguments.add(file.toString());
        }
        assertThat(ToolProvider.getSystemJavaCompiler().run(null, null, null, arguments.toArray(String[]::new)))
                .isZero();
        Manifest manifest = new Manifest();
        manifest.getMainAttributes().put(Attributes.Name.MANIFEST_VERSION, "1.0");
        manifest.getMainAttributes().put(Attributes.Name.IMPLEMENTATION_VERSION, "2.5");
        Path made = folder.resolve(name + ".jar");
        try (OutputStream out = Files.newOutputStream(made);
                JarOutputStream entries = new JarOutputStream(out, manifest);
                Stream<Path> files = Files.walk(classes)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                entries.putNextEntry(
                        new ZipEntry(classes.relativize(file).toString().replace('\\', '/')));
                entries.write(Files.readAllBytes(file));
            }
            for (int i = 0; i < services.length; i += 2) {
                entries.putNextEntry(new ZipEntry("META-INF/services/tompkins." + services[i]));
                entries.write(("optics." + services[i + 1] + "\n").getBytes(StandardCharsets.UTF_8));
            }
        }
        return made;
    }

    private static String grating(double beta) {
        return GRATING.replace("SPEED", String.valueOf(beta));
    }

    private static String torus(double x, String axis) {
        return TORUS.replace("ASIDE", String.valueOf(x)).replace("AXIS", axis);
    }

    /** Runs the program with other jars beside it, before it because tests use some of their types themselves. */
    private static Run run(List<Path> jars, String... words) throws IOException, InterruptedException {
        return run("tompkins.app.Main", jars, words);
    }

    private static Run run(String program, List<Path> jars, String... words) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of(
                RunningJava.PROGRAM,
                "-ea",
                "-XX:TieredStopAtLevel=1",
                "-Djava.awt.headless=true",
                "-cp",
                Stream.concat(jars.stream().map(Path::toString), Stream.of(RunningJava.CLASS_PATH))
                        .collect(Collectors.joining(File.pathSeparator)),
                program));
        command.addAll(List.of(words));
        Process process = new ProcessBuilder(command)
                .directory(folder.toFile())
                .redirectErrorStream(true)
                .start();
        String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        return new Run(process.waitFor(), out.strip());
    }

    /** The rays in the middle of some scenes: the numbers of {@link ExtensionProbe}, for each scene two rows. */
    private static List<double[]> probe(String... scenes) throws IOException, InterruptedException {
        String[] files = new String[scenes.length];
        for (int i = 0; i < scenes.length; i++) {
            files[i] = "probe" + i + ".json";
            Files.writeString(folder.resolve(files[i]), scenes[i]);
        }
        Run run = run(ExtensionProbe.class.getName(), List.of(jar), files);
        assertThat(run.code).as(run.out).isZero();
        return run.out
                .lines()
                .map(line -> Stream.of(line.split(" "))
                        .mapToDouble(Double::parseDouble)
                        .toArray())
                .toList();
    }

    /** The places of the hits along the axis of the camera, and the wall. */
    private static double[] depths(double... row) {
        return IntStream.range(0, row.length / 6)
                .mapToDouble(hit -> row[6 * hit + 3])
                .toArray();
    }

    @Test
    void gratingShowsTheDopplerFactor() throws IOException, InterruptedException {
        List<double[]> rows = probe(grating(0), grating(0.6), grating(-0.6));

        double[] factors = {1, 2, 0.5};
        for (int i = 0; i < factors.length; i++) {
            double sine = 0.2 * factors[i];
            double slope = (rows.get(2 * i)[7] - rows.get(2 * i)[1]) / 5;
            assertThat(slope).isCloseTo(sine / Math.sqrt(1 - sine * sine), within(1e-12));
        }
        // the iris: a tenth of the radius later at the edge of the lens
        assertThat(rows.get(0)[0]).isEqualTo(3);
        assertThat(rows.get(1)[0]).isCloseTo(3 + 0.1 * 0.5, within(1e-12));
    }

    /** The plane of the axis and a ray cuts a torus in two circles. */
    @Test
    void torusIsMetWhereCirclesAreCut() throws IOException, InterruptedException {
        double tilt = Math.toRadians(80);
        List<double[]> rows = probe(
                torus(0, "0, 0, 1"),
                torus(2, "0, 0, -3"),
                torus(0, "1, 0, 0"),
                torus(0, Math.sin(tilt) + ", 0, " + Math.cos(tilt)),
                torus(2, "0, 0, 1").replace("{\"type\": \"Torus\"", TURNING).replace("\"Clear\"}}", "\"Clear\"}}]}"));

        // through the hole, through the tube along the axis, and across
        assertThat(depths(rows.get(0))).containsExactly(20);
        assertThat(depths(rows.get(2))).containsExactly(new double[] {9.5, 10.5, 20}, within(1e-12));
        assertThat(depths(rows.get(4))).containsExactly(new double[] {7.5, 8.5, 11.5, 12.5, 20}, within(1e-12));
        // (s sin - 2)^2 + (s cos)^2 = 0.5^2
        double middle = 2 * Math.sin(tilt);
        double half = Math.sqrt(middle * middle - 2 * 2 + 0.5 * 0.5);
        assertThat(depths(rows.get(6)))
                .containsExactly(
                        new double[] {10 - middle - half, 10 - middle + half, 10 + middle - half, 10 + middle + half, 20
                        },
                        within(1e-12));
        // what turns about its own axis is where it was
        assertThat(depths(rows.get(8))).containsExactly(new double[] {9.5, 10.5, 20}, within(1e-9));
        // out of the tube, towards the camera
        assertThat(Arrays.copyOfRange(rows.get(2), 4, 7)).containsExactly(new double[] {0, 0, -1}, within(1e-12));
    }

    @Test
    void allCommandsKnowAddedTypes() throws IOException, InterruptedException {
        Files.writeString(folder.resolve("scene.json"), grating(0.6));
        List<Path> jars = List.of(jar);

        Matcher page = Pattern.compile("```json\n(.*?)```", Pattern.DOTALL)
                .matcher(Files.readString(Path.of("docs/extending.md")));
        assertThat(page.find()).isTrue();
        Files.writeString(folder.resolve("page.json"), page.group(1));

        Run explained = run(jars, "explain", "page.json");
        assertThat(explained.code).as(explained.out).isZero();
        assertThat(explained.out).contains("do nothing else to it: Grating.");
        Run picture = run(jars, "render", "scene.json", "--set", "scene[0].surface.orders=0.1", "-o", "grating.png");
        assertThat(picture.code).as(picture.out).isZero();
        Path photograph = folder.resolve("grating.png");
        assertThat(PhotographFile.readScene(photograph).orElseThrow()).contains("\"Grating\"");
        assertThat(Files.readString(photograph, StandardCharsets.ISO_8859_1))
                .contains("Tompkins " + SelfDescription.version() + " with optics.jar 2.5");
        assertThat(run(jars, "check", "scene.json", "--set", "scene[0].surface.orders=7"))
                .isEqualTo(new Run(2, "--set: scene[0].surface.orders: must be from -1 to 1, was 7"));
        assertThat(run(jars, "check", "scene.json", "--set", "scene[0].surface.type=Gratin").out)
                .endsWith("Grating with optics.jar 2.5; did you mean \"Grating\"?");
    }

    @Test
    void directionsOfAnotherLengthAreFound() throws IOException, InterruptedException {
        Path crooked = jar(
                "crooked",
                List.of("package optics; import tompkins.ray.*; import tompkins.surface.*; "
                        + "public record Crooked() implements AddedSurface { "
                        + "public static final Crooked DEFAULT = new Crooked(); "
                        + "public Response respond(Ray ray, Hit hit, Tracer tracer) { "
                        + "return Response.goesOn(ray.bent(hit, 0, 0.5, 1, 1), Colour.WHITE); } }"),
                SURFACE,
                "Crooked");
        Files.writeString(
                folder.resolve("crooked.json"),
                "{\"scene\": [{\"type\": \"Sphere\", \"surface\": {\"type\": \"Crooked\"}}]}");

        Run run = run(ExtensionProbe.class.getName(), List.of(crooked), "crooked.json");

        assertThat(run.code).isNotZero();
        assertThat(run.out).contains("direction (0.0, 0.5, 1.0) is no unit vector, at \"sphere\", Crooked[]");
    }

    private static Run start(Path... jars) throws IOException, InterruptedException {
        return run(List.of(jars), "--version");
    }

    @Test
    void wrongTypesEndTheProgramWithOneSentence() throws IOException, InterruptedException {
        String head = "package optics; import tompkins.ray.*; import tompkins.surface.*; public ";
        String body = "public Response respond(Ray r, Hit h, Tracer t) { return Response.ends(Colour.BLACK); } }";
        String record = head + "record Dull() implements AddedSurface { ";
        Path noRecord = jar("class", List.of(head + "class Dull implements AddedSurface { " + body), SURFACE, "Dull");
        Path noDefault = jar("plain", List.of(record + body), SURFACE, "Dull");
        Path failing = jar(
                "failing",
                List.of(record + "public static final Dull DEFAULT = new Dull(); "
                        + "public Dull { if (true) throw new IllegalStateException(\"dull\"); } " + body),
                SURFACE,
                "Dull");
        String mirror = head + "record Mirror() implements AddedSurface { "
                + "public static final Mirror DEFAULT = new Mirror(); " + body;
        Path twice = jar("twice", List.of(mirror), SURFACE, "Mirror");
        Path nothing = jar("none", List.of(record + body), SURFACE, "None");

        assertThat(start(noRecord)).isEqualTo(new Run(2, "class.jar 2.5: optics.Dull must be a record"));
        assertThat(start(noDefault))
                .isEqualTo(new Run(2, "plain.jar 2.5: optics.Dull must be public, with a public constant DEFAULT"));
        assertThat(start(failing))
                .isEqualTo(new Run(
                        2, "failing.jar 2.5: optics.Dull cannot be loaded: java.lang.IllegalStateException: dull"));
        assertThat(start(twice))
                .isEqualTo(new Run(
                        2, "twice.jar 2.5: optics.Mirror must have a name of its own: there is another type Mirror"));
        Run missing = start(jar, nothing);
        assertThat(missing.code).isEqualTo(2);
        assertThat(missing.out).startsWith("none.jar: ").contains("optics.None").doesNotContain("\n");
    }

    @Test
    void classFilesOfANewerJavaEndTheProgram() throws IOException, InterruptedException {
        Path made = folder.resolve("optics.jar");
        Path newer = folder.resolve("newer.jar");
        try (JarFile from = new JarFile(made.toFile());
                JarOutputStream to = new JarOutputStream(Files.newOutputStream(newer))) {
            for (JarEntry entry : Collections.list(from.entries())) {
                byte[] content = from.getInputStream(entry).readAllBytes();
                if (entry.getName().endsWith(".class")) {
                    // the version of the format, of a Java that is to come
                    content[7] = 120;
                }
                to.putNextEntry(new ZipEntry(entry.getName()));
                to.write(content);
            }
        }

        Run run = start(newer);

        assertThat(run.code).isEqualTo(2);
        assertThat(run.out)
                .startsWith("newer.jar: ")
                .contains("more recent version")
                .doesNotContain("\n");
    }
}
