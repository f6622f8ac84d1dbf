package tompkins.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.joml.Vector2i;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.MessageTable;
import tompkins.camera.FocusDistance;
import tompkins.property.Descriptions;
import tompkins.property.MistakeException;
import tompkins.sceneobject.ImagePointGrid;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.Sphere;
import tompkins.shutter.DetectorPlaneShutter;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;
import tompkins.studio.FrontWindow;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;
import tompkins.surface.LorentzWindow;

class AssignmentsTest {

    private static final Path HERE = Path.of("");

    private static final Studio STUDIO = Studio.DEFAULT
            .withScene(List.of(Plane.DEFAULT, Sphere.DEFAULT))
            .withVelocity(Velocity.of(SpeedScale.BETA, 0.6, new Vector3d(1, 0, 0)));

    /** The studio after settings that are separated by two spaces. */
    private static Studio with(Studio studio, String settings) {
        return Assignments.applyTo(studio, assignments(settings), HERE);
    }

    private static List<Assignment> assignments(String settings) {
        return Arrays.stream(settings.split("  "))
                .map(setting -> setting.split("=", 2))
                .map(parts -> new Assignment("--set", parts[0], parts[1]))
                .toList();
    }

    private static Sphere sphere(Studio studio) {
        return (Sphere) studio.scene().get(1);
    }

    @Test
    void aNumberMayEndOrBeginWithItsPoint() {
        Studio studio = with(STUDIO, "scene[1].radius=2.  scene[1].centre=1.,.5,-3.");
        assertThat(sphere(studio).radius()).isEqualTo(2);
        assertThat(sphere(studio).centre()).isEqualTo(new Vector3d(1, 0.5, -3));
    }

    @Test
    void pathsOfAnyLengthAreRefusedInALine() {
        assertThatThrownBy(() -> with(STUDIO, "a" + ".a".repeat(50_000) + "=1"))
                .hasMessageStartingWith("--set: unknown key \"a\"");
        assertThatThrownBy(() -> with(STUDIO, "!".repeat(50_000) + "=1"))
                .hasMessageEndingWith("... (50000 characters)");
    }

    @Test
    void anyKeyTakesAValueAsInTheFile() {
        Studio studio = with(
                STUDIO,
                "title=a 'b'  settings.width=12  settings.seed=-9007199254740993  colours=doppler  scene[1].radius=.5"
                        + "  scene[1].centre.y=7  scene[0].normal=0,1,0  scene[1].surface.diffuse.green=0.25"
                        + "  camera.shutter.openingTime=1e-3  lights=[{\"type\": \"AmbientLight\"}]");

        assertThat(studio.title()).isEqualTo("a 'b'");
        assertThat(studio.settings())
                .isEqualTo(RenderSettings.DEFAULT.withSize(12, 480).withSeed(-9007199254740993L));
        assertThat(sphere(studio).radius()).isEqualTo(0.5);
        assertThat(sphere(studio).centre()).isEqualTo(new Vector3d(0, 7, 10));
        assertThat(((Plane) studio.scene().get(0)).normal()).isEqualTo(new Vector3d(0, 1, 0));
        assertThat(studio.camera().shutter().openingTime()).isEqualTo(1e-3);
        assertThat(studio.lights()).hasSize(1);
        assertThat(StudioWriter.write(studio)).contains("[0.8, 0.25, 0.8]", "\"colours\": \"doppler\"");
    }

    /** A comma is a decimal one where a single number belongs, and stands between two where a pair belongs. */
    @Test
    void aPairIsWrittenWithAComma() {
        Studio studio = STUDIO.withScene(List.of(ImagePointGrid.DEFAULT, Sphere.DEFAULT));
        assertThat(((ImagePointGrid) with(studio, "scene[0].points=5,7").scene().get(0)).points())
                .isEqualTo(new Vector2i(5, 7));
        assertThat(sphere(with(studio, "scene[1].radius=1,5")).radius()).isEqualTo(1.5);
    }

    /** gamma of 3/5 is 5/4. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "velocity.gamma=1.25 | 0.6, 0, 0",
                "velocity.beta=0.5 | 0.5, 0, 0",
                "velocity.direction=[0, 0, -2] | 0, 0, -0.6",
                "velocity.gamma=1.25  velocity.direction=0,3,4 | 0, 0.36, 0.48",
                "velocity=[0, 0, 0.25] | 0, 0, 0.25",
                "velocity={\"beta\": 0.5} | 0, 0, 0.5"
            })
    void aVelocityKeepsWhatIsNotSet(String settings, String expected) {
        double[] beta =
                Stream.of(expected.split(", ")).mapToDouble(Double::parseDouble).toArray();
        assertThat(with(STUDIO, settings).velocity().components().distance(beta[0], beta[1], beta[2]))
                .isLessThan(1e-15);
    }

    /** 65535 x 480 pixels, and 640 x 65535, are few enough; together they are not. */
    @Test
    void valuesCountTogetherInAnyOrder() {
        Studio wide = STUDIO.withSettings(RenderSettings.DEFAULT.withSize(65_535, 480));
        for (String order :
                List.of("settings.width=640  settings.height=65535", "settings.height=65535  settings.width=640")) {
            assertThat(with(wide, order).settings()).isEqualTo(RenderSettings.DEFAULT.withSize(640, 65_535));
        }
    }

    @Test
    void anotherTypeHasItsOwnDefaults() {
        Studio studio = with(
                STUDIO,
                "camera.shutter.detectorDistance=2  camera.shutter.type=DetectorPlaneShutter  scene[1].type=Plane");
        assertThat(studio.camera().shutter())
                .isEqualTo(Descriptions.with(DetectorPlaneShutter.DEFAULT, "detectorDistance", 2.0));
        assertThat(studio.scene()).containsExactly(Plane.DEFAULT, Plane.DEFAULT);
        Studio same = with(STUDIO, "scene[1].radius=3  scene[1].type=Sphere");
        assertThat(sphere(same).radius()).isEqualTo(3);
    }

    /** A number takes the place of whatever was in focus, and is written as a distance. */
    @Test
    void aNumberAsFocusIsADistance() {
        Studio onSphere = with(Studio.DEFAULT, "camera.focus.type=Sphere");
        for (String settings : List.of("camera.focus=12", "camera.focusDistance=12")) {
            Studio studio = with(settings.contains("Distance") ? Studio.DEFAULT : onSphere, settings);
            assertThat(FocusDistance.of(studio.camera())).isEqualTo(12);
            assertThat(StudioWriter.write(studio, Path.of("scene.json")))
                    .contains("\"focusDistance\": 12")
                    .doesNotContain("\"focus\"");
            assertThat(with(studio, "camera.focus=3")).isEqualTo(with(Studio.DEFAULT, "camera.focusDistance=3"));
        }
    }

    @Test
    void theWindowBeforeTheLensFollows() {
        Studio windowed = FrontWindow.with(STUDIO, LorentzWindow.DEFAULT.withVelocity(STUDIO.velocity()));
        assertThat(FrontWindow.matches(with(windowed, "velocity.beta=0.5"))).isTrue();
        assertThat(FrontWindow.matches(with(windowed, "velocity.beta=0.5  cameraFrame[0].surface.velocity.beta=0.4")))
                .isFalse();
        String still = "velocity.beta=0.5  cameraFrame[0].surface.velocity.beta=0.6";
        assertThat(FrontWindow.matches(with(windowed, still))).isFalse();
    }

    @Test
    void mistakesAreToldAsInTheFile() throws IOException {
        MessageTable.assertTold(
                "tompkins/io/assignments.txt",
                settings -> catchThrowableOfType(MistakeException.class, () -> with(STUDIO, settings))
                        .getMessage(),
                getClass());
    }

    @Test
    void allMistakesAreToldAtOnceEachWithItsOption() {
        List<Assignment> wrong = List.of(
                new Assignment("--gamma", "velocity.gamma", "0.5"),
                new Assignment("--size", "settings.width", "0"),
                new Assignment("--set", "scene[1].radius", "0"));
        assertThatThrownBy(() -> Assignments.applyTo(STUDIO, wrong, HERE))
                .hasMessageContaining("--gamma: velocity.gamma: must be 1 or above, was 0.5")
                .hasMessageContaining("--size: settings.width: must be a whole number from 1 to 65535, was 0")
                .hasMessageContaining("--set: scene[1].radius: must be a finite number above 0, was 0");
    }
}
