package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.OnLinux;
import tompkins.animation.Animation;
import tompkins.image.ToneCurve;
import tompkins.io.StudioReader;
import tompkins.io.StudioWriter;
import tompkins.light.ColourLaw;
import tompkins.light.Metering;
import tompkins.property.Descriptions;
import tompkins.ray.PixelPicture;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.shutter.DetectorPlaneShutter;
import tompkins.shutter.FixedPointSurfaceShutter;
import tompkins.shutter.FocusSurfaceShutter;
import tompkins.shutter.RollingShutter;
import tompkins.shutter.Shutter;
import tompkins.shutter.SweepDirection;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.FrontWindow;
import tompkins.studio.PanoramaBackground;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;
import tompkins.studio.StudioNumber;
import tompkins.studio.View;
import tompkins.surface.LorentzWindow;

@OnLinux
class WindowCommandLineTest {

    private static final Studio OPENED =
            Studio.DEFAULT.withScene(List.of(Sphere.DEFAULT)).withSettings(RenderSettings.DEFAULT.withSize(8, 6));

    private static final Path JAR = Path.of("/programs/tompkins.jar");
    private static final String PROGRAM = "java -jar /programs/tompkins.jar ";

    @TempDir
    private Path folder;

    private Path file;

    @BeforeEach
    void save() throws IOException {
        file = folder.resolve("scene.json");
        StudioWriter.save(OPENED, file, true);
    }

    private static Studio with(Shutter shutter) {
        return OPENED.withCamera(OPENED.camera().withShutter(shutter));
    }

    private static Studio exposed(double time, RollingShutter rolling) {
        return OPENED.withCamera(OPENED.camera().withExposureTime(time).withRollingShutter(rolling));
    }

    static Stream<Studio> sayable() {
        return Stream.of(
                OPENED,
                OPENED.withSettings(OPENED.settings().withSize(10, 7)),
                OPENED.withSettings(OPENED.settings().withSamples(3).withSeed(-5)),
                OPENED.withSettings(Descriptions.with(OPENED.settings(), "toneCurve", ToneCurve.SRGB)),
                OPENED.withVelocity(Velocity.of(-0.1, 0.2, 1.0 / 3)),
                OPENED.withColours(ColourLaw.SEARCHLIGHT),
                OPENED.withMetering(Metering.NONE),
                OPENED.withView(View.MEASURED),
                with(OPENED.camera().shutter().openedAt(-1.5)),
                with(FocusSurfaceShutter.DEFAULT),
                exposed(0.25, RollingShutter.DEFAULT),
                exposed(0, new RollingShutter(SweepDirection.LEFT, 0)),
                exposed(3, new RollingShutter(SweepDirection.UP, 2.5)),
                with(FixedPointSurfaceShutter.DEFAULT),
                OPENED.withScene(List.of()),
                OPENED.withScene(List.of(Descriptions.with(Sphere.DEFAULT, "description", "it's \"one\""))),
                OPENED.withScene(List.of(Plane.DEFAULT)),
                OPENED.withTransformation(TransformationLaw.GALILEAN),
                OPENED.withVelocity(Velocity.of(SpeedScale.GAMMA, 1e7, new Vector3d(0, 1, 1))),
                OPENED.withVelocity(Velocity.of(SpeedScale.ONE_MINUS_BETA, 5.3e-17, new Vector3d(0, 1e-9, 1))),
                OPENED.withVelocity(Velocity.of(SpeedScale.RAPIDITY, 2, new Vector3d(0, 0, 3))),
                with(DetectorPlaneShutter.DEFAULT.openedAt(0.125))
                        .withVelocity(Velocity.of(0, 0, -0.5))
                        .withSettings(OPENED.settings().withSamples(2)));
    }

    /** The program itself is asked: the photograph that the command line takes holds the scene of the window. */
    @ParameterizedTest
    @MethodSource
    void sayable(Studio studio) throws IOException {
        Path photograph = folder.resolve("photograph.png");
        List<Object> words = words(studio);
        words.addAll(List.of("-o", photograph));

        ProgramRun run = ProgramRun.of(words.toArray());

        assertThat(run.code()).as(run.err()).isZero();
        assertThat(StudioReader.read(photograph)).isEqualTo(studio);
    }

    private static Optional<String> line(Studio studio, Path from) {
        return new WindowCommandLine(JAR).photograph(studio, OPENED, from);
    }

    @Test
    void aWantedErrorIsSaidInsteadOfTheSamples() {
        Studio studio = OPENED.withSettings(OPENED.settings().withSamples(7).withTargetError(0.005));
        assertThat(line(studio, file)).contains(PROGRAM + "render " + file + " --error=0.005");
        WindowCommandLine writer = new WindowCommandLine(JAR);
        assertThat(writer.photograph(studio, studio, file)).contains(PROGRAM + "render " + file);
        Studio even = studio.withSettings(studio.settings().withTargetError(0));
        assertThat(writer.photograph(even, studio, file)).contains(PROGRAM + "render " + file + " --samples 7");
    }

    static Stream<Arguments> animations() {
        Studio changed = OPENED.withSettings(OPENED.settings().withSize(10, 7).withSamples(3))
                .withVelocity(Velocity.of(SpeedScale.BETA, 0.4, new Vector3d(0, 0, 1)));
        Studio reseeded =
                OPENED.withSettings(Descriptions.with(OPENED.settings().withSeed(7), "toneCurve", ToneCurve.SRGB));
        Studio aside = OPENED.withVelocity(Velocity.of(SpeedScale.RAPIDITY, 0, new Vector3d(0.6, 0, -0.8)));
        return Stream.of(
                Arguments.of(changed, animation("velocity.beta", 0, 0.75, Animation.Course.FORWARDS)),
                Arguments.of(reseeded, animation("velocity.beta", 0.5, 0.25, Animation.Course.FORWARDS)),
                Arguments.of(aside, animation("velocity.rapidity", 2, 0, Animation.Course.BACKWARDS)),
                Arguments.of(
                        with(OPENED.camera().shutter().openedAt(2)),
                        animation("camera.shutter.openingTime", -1, 3, Animation.Course.BACKWARDS)),
                Arguments.of(
                        StudioNumber.at("scene[0].radius", OPENED).with(changed, 0.7),
                        animation("scene[0].radius", 1.25, 1e-3, Animation.Course.THERE_AND_BACK)));
    }

    private static Animation animation(String place, double from, double to, Animation.Course course) {
        return new Animation(StudioNumber.at(place, OPENED), from, to, 0.2, course);
    }

    /** The program itself is asked, wherever the number of the window has got to. */
    @ParameterizedTest
    @MethodSource
    void animations(Studio studio, Animation animation) throws IOException {
        Path frames = folder.resolve("frames");
        String line = new WindowCommandLine(JAR)
                .animation(studio, animation, false, OPENED, file)
                .orElseThrow();
        List<Object> words = words("animate", line);
        words.set(words.size() - 1, frames);

        ProgramRun run = ProgramRun.of(words.toArray());

        assertThat(run.code()).as(run.err()).isZero();
        assertThat(animation.frames()).isEqualTo(5);
        for (int frame = 0; frame < 5; frame++) {
            Studio taken = StudioReader.read(frames.resolve("frame000" + frame + ".png"));
            Studio meant = animation.studio(studio, animation.timeOf(frame));
            assertThat(taken.withVelocity(meant.velocity())).isEqualTo(meant);
            assertThat(taken.velocity().proper().distance(meant.velocity().proper()))
                    .isLessThan(1e-15);
        }
        assertThat(new WindowCommandLine(JAR).animation(studio, animation, true, OPENED, file))
                .contains(line.replace(" -o ", " --caption -o "));
    }

    @Test
    void withoutAFileThereIsNothingToAnimate() {
        Animation animation = animation("velocity.beta", 0, 0.75, Animation.Course.FORWARDS);
        assertThat(new WindowCommandLine(JAR).animation(OPENED, animation, false, OPENED, null))
                .isEmpty();
    }

    private List<Object> words(Studio studio) throws IOException {
        return words("render", line(studio, file).orElseThrow());
    }

    /** The words that a shell makes of a line, without those that name the program. */
    private static List<Object> words(String command, String line) throws IOException {
        assertThat(line).startsWith(PROGRAM + command + " ");
        Process shell = new ProcessBuilder("sh", "-c", "printf '%s\\n' " + line.substring(PROGRAM.length())).start();
        String words = new String(shell.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        return new ArrayList<>(words.lines().toList());
    }

    @Test
    void valuesAreSaidWithTheirShortOptions() {
        Studio studio = OPENED.withVelocity(Velocity.of(SpeedScale.RAPIDITY, 2, new Vector3d(0, 0, 1)))
                .withColours(ColourLaw.DOPPLER)
                .withSettings(OPENED.settings().withSize(9, 6).withSeed(3).withMaximumDepth(7));
        assertThat(line(studio, file))
                .contains(
                        PROGRAM + "render " + file
                                + " --set velocity.rapidity=2 --colours=doppler --size 9x6 --seed=3 --set settings.maximumDepth=7");
        assertThat(line(OPENED.withVelocity(Velocity.of(0, 0.5, -0.25)), file).orElseThrow())
                .endsWith(" --beta=0,0.5,-0.25");
    }

    @Test
    void aWindowBeforeTheLensIsNotSaidIfItFollows() {
        Studio before = FrontWindow.with(OPENED, LorentzWindow.DEFAULT.withVelocity(OPENED.velocity()));
        Studio after = FrontWindow.withVelocity(before, Velocity.of(SpeedScale.BETA, 0.5, new Vector3d(0, 0, 1)));
        assertThat(new WindowCommandLine(JAR).photograph(after, before, file).orElseThrow())
                .endsWith("scene.json --beta=0.5");
    }

    static Stream<Studio> unsayable() {
        List<SceneObject> many = Collections.nCopies(300, Sphere.DEFAULT);
        PixelPicture elsewhere = new PixelPicture("elsewhere.png", 1, 1, new float[4], new byte[0]);
        return Stream.of(
                OPENED.withScene(many),
                Descriptions.with(
                        OPENED, "background", Descriptions.with(PanoramaBackground.DEFAULT, "picture", elsewhere)));
    }

    @ParameterizedTest
    @MethodSource
    void unsayable(Studio studio) {
        assertThat(line(studio, file)).isEmpty();
    }

    @Test
    void withoutAFileThereIsNothingToRender() {
        assertThat(line(OPENED, null)).isEmpty();
    }

    /** Options and files of arguments begin with these letters, whole paths do not. */
    @ParameterizedTest
    @ValueSource(strings = {"one.json", "-o.json", "one-@.json"})
    void aSceneOfThisFolderIsNamedForAllFolders(String name) {
        String here = Path.of("").toAbsolutePath() + "/";
        assertThat(line(OPENED, Path.of(name)).orElseThrow().replace("'", ""))
                .isEqualTo(PROGRAM + "render " + here + name);
    }

    @Test
    void theJarThatRunsIsNamed() throws IOException {
        Path programs = Files.createDirectory(folder.resolve("it's mine"));
        Path jar = Files.createFile(programs.resolve("tompkins-2.jar"));

        assertThat(lineOf(new WindowCommandLine(jar)))
                .isEqualTo("java -jar '" + folder + "/it'\\''s mine/tompkins-2.jar' render " + file);
    }

    /** The tests run from classes. */
    @Test
    void fromClassesTheJarThatMavenMakesOfThemIsNamed() {
        String target = Path.of(System.getProperty("basedir", ""), "target").toAbsolutePath() + "/";
        assertThat(lineOf(new WindowCommandLine())).isEqualTo("java -jar " + target + "tompkins.jar render " + file);
    }

    private String lineOf(WindowCommandLine writer) {
        return writer.photograph(OPENED, OPENED, file).orElseThrow();
    }

    /** The shell itself is asked: what it makes of the copied line. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "it's",
                "''",
                "two words",
                "$HOME",
                "`id`",
                "a\"b",
                "a\\b",
                "x;y&z",
                "~",
                "*",
                "caf\u00e9",
                "a,b",
                "#1"
            })
    void shellTakesTheNameForOneWord(String name) throws IOException, InterruptedException {
        Path named = folder.resolve(name + ".json");
        String words = line(OPENED, named).orElseThrow().substring(PROGRAM.length());
        Path script = Files.writeString(folder.resolve("script"), "printf '<%s>' " + words);

        Process shell = new ProcessBuilder("sh", script.toString()).start();

        String said = new String(shell.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(shell.waitFor()).isZero();
        assertThat(said).isEqualTo("<render><" + named + ">");
    }

    @Test
    void namesWithSpacesAreQuoted() throws IOException {
        Path spaced = Files.createDirectories(folder.resolve("my scenes")).resolve("one.json");
        assertThat(line(OPENED, spaced)).contains(PROGRAM + "render '" + spaced + "'");
    }
}
