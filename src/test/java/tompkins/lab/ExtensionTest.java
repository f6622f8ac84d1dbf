package tompkins.lab;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.jar.Attributes;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.image.PhotographFile;

/** Types of another jar: those that {@code docs/extending.md} shows, and wrong ones. */
class ExtensionTest {

    private static final String SURFACES = "META-INF/services/tompkins.surface.AddedSurface";
    private static final String SHUTTERS = "META-INF/services/tompkins.shutter.AddedShutter";
    private static final Pattern PROGRAM = Pattern.compile("```java\n(.*?)```", Pattern.DOTALL);

    /** A grating before a wall, and a lens as wide as the iris delays. */
    private static final String SCENE = """
            {"velocity": [0, 0, %s], "settings": {"width": 40, "height": 30},
             "camera": {"apertureRadius": 0.5, "shutter": {"type": "IrisShutter"}},
             "scene": [
                {"type": "Parallelogram", "corner": [-9, -9, 4], "spanU": [18, 0, 0], "spanV": [0, 18, 0],
                 "surface": {"type": "Grating", "orders": 0.2}},
                {"type": "Plane", "point": [0, 0, 9], "normal": [0, 0, -1]}]}""";

    @TempDir
    private static Path folder;

    private static Path jar;

    private record Run(int code, String out) {}

    @BeforeAll
    static void makeJar() throws IOException {
        Matcher page = PROGRAM.matcher(Files.readString(Path.of("docs/extending.md")));
        assertThat(page.find()).isTrue();
        String iris;
        try (InputStream in = ExtensionTest.class.getResourceAsStream("IrisShutter.java.txt")) {
            iris = new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
        jar = jar("optics", List.of(page.group(1), iris), SURFACES, "optics.Grating", SHUTTERS, "optics.IrisShutter");
    }

    /** A jar of records in the package {@code optics}, with files that name them. */
    private static Path jar(String name, List<String> sources, String... services) throws IOException {
        Path classes = Files.createDirectories(folder.resolve(name + "-classes"));
        List<String> arguments = new ArrayList<>(List.of("-cp", classPath(), "-proc:none", "-d", classes.toString()));
        for (String source : sources) {
            Matcher record =
                    Pattern.compile("public (?:final )?(?:record|class) (\\w+)").matcher(source);
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
                entries.putNextEntry(new ZipEntry(services[i]));
                entries.write(services[i + 1].getBytes(StandardCharsets.UTF_8));
            }
        }
        return made;
    }

    private static String classPath() {
        return Stream.of(System.getProperty("java.class.path").split(File.pathSeparator))
                .map(part -> Path.of(part).toAbsolutePath().toString())
                .collect(Collectors.joining(File.pathSeparator));
    }

    private static Run run(Path extension, String... words) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:TieredStopAtLevel=1",
                "-Djava.awt.headless=true",
                "-cp",
                classPath() + File.pathSeparator + extension,
                "tompkins.app.Main"));
        command.addAll(List.of(words));
        Process process = new ProcessBuilder(command)
                .directory(folder.toFile())
                .redirectErrorStream(true)
                .start();
        String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        return new Run(process.waitFor(), out.strip());
    }

    @ParameterizedTest
    @CsvSource({"0, 1", "0.6, 2", "-0.6, 0.5"})
    void gratingShowsTheDopplerFactor(double beta, double factor) throws IOException, InterruptedException {
        Files.writeString(folder.resolve("grating.json"), String.format(SCENE, beta));

        Run run = run(jar, "trace", "grating.json", "--pixel", "19,14", "--csv");

        assertThat(run.code()).as(run.out).isZero();
        String[] lines = run.out.lines().filter(line -> line.contains(",")).toArray(String[]::new);
        List<String> names = List.of(lines[0].split(","));
        String[] values = lines[1].split(",");
        double slopeX = value(names, values, "hit_scene_x") - value(names, values, "scene_x");
        double sine = 0.2 * factor;
        // half a pixel beside the middle turns the direction a little
        assertThat(slopeX).isCloseTo(5 * sine / Math.sqrt(1 - sine * sine), within(0.25));
    }

    private static double value(List<String> names, String[] values, String name) {
        return Double.parseDouble(values[names.indexOf(name)]);
    }

    @Test
    void irisOpensFromItsCentre() throws IOException, InterruptedException {
        Files.writeString(folder.resolve("iris.json"), String.format(SCENE, 0));

        Run centre = run(jar, "trace", "iris.json", "--pixel", "19,14", "--json", "--time", "3");
        Run rim = run(jar, "trace", "iris.json", "--pixel", "19,14", "--json", "--time", "3", "--pupil", "0.6,0.8");

        assertThat(centre.out).contains("\"time\" : 3,");
        assertThat(rim.out).contains("\"time\" : 3.05");
    }

    @Test
    void allCommandsKnowAddedTypes() throws IOException, InterruptedException {
        Files.writeString(folder.resolve("scene.json"), String.format(SCENE, 0.6));

        assertThat(run(jar, "check", "scene.json").code).isZero();
        assertThat(run(jar, "explain", "scene.json").code).isZero();
        Run picture = run(jar, "render", "scene.json", "--set", "scene[0].surface.orders=0.1", "-o", "grating.png");
        assertThat(picture.code).as(picture.out).isZero();
        assertThat(PhotographFile.readScene(folder.resolve("grating.png")).orElseThrow())
                .contains("\"Grating\"");
        assertThat(new String(Files.readAllBytes(folder.resolve("grating.png")), StandardCharsets.ISO_8859_1))
                .contains("optics.jar 2.5");
        assertThat(run(jar, "check", "scene.json", "--set", "scene[0].surface.orders=7"))
                .isEqualTo(new Run(2, "--set: scene[0].surface.orders: must be from -1 to 1, was 7"));
        assertThat(run(jar, "check", "scene.json", "--set", "scene[0].surface.type=Gratin").out)
                .contains("did you mean \"Grating\"?");
    }

    @Test
    void wrongTypesEndTheProgramWithOneSentence() throws IOException, InterruptedException {
        String head = "package optics; import tompkins.ray.*; import tompkins.surface.*; public ";
        String body = "public Response respond(Ray r, Hit h, Tracer t) { return Response.ends(Colour.BLACK); } }";
        Path noRecord =
                jar("class", List.of(head + "class Dull implements AddedSurface { " + body), SURFACES, "optics.Dull");
        Path noDefault = jar(
                "plain", List.of(head + "record Dull() implements AddedSurface { " + body), SURFACES, "optics.Dull");
        Path twice = jar(
                "twice",
                List.of(head
                        + "record Mirror() implements AddedSurface { public static final Mirror DEFAULT = new Mirror(); "
                        + body),
                SURFACES,
                "optics.Mirror");
        Path nothing =
                jar("none", List.of(head + "record Dull() implements AddedSurface { " + body), SURFACES, "optics.None");

        assertThat(run(noRecord, "--version")).isEqualTo(new Run(2, "class.jar 2.5: optics.Dull must be a record"));
        assertThat(run(noDefault, "--version"))
                .isEqualTo(new Run(2, "plain.jar 2.5: optics.Dull must be public, with a public constant DEFAULT"));
        assertThat(run(twice, "--version"))
                .isEqualTo(new Run(
                        2, "twice.jar 2.5: optics.Mirror must have a name of its own: there is another type Mirror"));
        Run missing = run(nothing, "--version");
        assertThat(missing.code).isEqualTo(2);
        assertThat(missing.out).startsWith("none.jar: ").contains("optics.None").doesNotContain("\n");
    }
}
