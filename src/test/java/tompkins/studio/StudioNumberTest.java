package tompkins.studio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.light.MovingLights;
import tompkins.property.Descriptions;
import tompkins.property.InvalidPropertyException;
import tompkins.sceneobject.Group;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;
import tompkins.surface.LorentzWindow;

class StudioNumberTest {

    private static final Studio STUDIO = Studio.DEFAULT
            .withScene(List.of(
                    Plane.DEFAULT,
                    new Group("pair", List.of(Sphere.DEFAULT, Descriptions.with(Sphere.DEFAULT, "radius", 0.25)))))
            .withVelocity(Velocity.of(SpeedScale.BETA, 0.6, new Vector3d(1, 0, 0)));

    /** gamma and rapidity of 0.6 are 5/4 and ln 2. */
    @ParameterizedTest
    @CsvSource({
        "velocity.beta, 0.6",
        "velocity.gamma, 1.25",
        "velocity.rapidity, 0.6931471805599453",
        "velocity.oneMinusBeta, 0.4",
        "scene[1].objects[1].radius, 0.25",
        "camera.shutter.openingTime, 0"
    })
    void placesAreWrittenAsInMessages(String place, double value) {
        StudioNumber number = StudioNumber.at(place, STUDIO);
        assertThat(number.in(STUDIO)).isCloseTo(value, within(1e-15));
        assertThat(number.path()).hasToString(place);
        Studio changed = number.with(STUDIO, 0.3 + number.in(STUDIO));
        assertThat(number.in(changed)).isCloseTo(0.3 + value, within(1e-15));
        assertThat(number.with(changed, number.in(STUDIO)).scene()).isEqualTo(STUDIO.scene());
    }

    @ParameterizedTest
    @CsvSource({
        "scene[0].velocity.beta, 0.6, 0.8",
        "scene[0].velocity.gamma, 1.25, 3",
        "scene[0].velocity.rapidity, 0.6931471805599453, 2",
        "scene[0].velocity.oneMinusBeta, 0.4, 1e-6",
        "scene[0].place.y, 2, -7",
        "scene[0].clockOffset, 4, 5.5",
        "scene[0].objects[0].objects[0].radius, 1, 0.5",
        "scene[0].objects[0].velocity.beta, 0.3, 0.9",
        "lights[0].velocity.beta, 0.5, 0.25",
        "lights[0].place.z, 0, 3"
    })
    void numbersOfWhatMovesAreReached(String place, double value, double next) {
        Velocity fast = Velocity.of(SpeedScale.BETA, 0.6, new Vector3d(1, 0, 0));
        Velocity slow = Velocity.of(SpeedScale.BETA, 0.3, new Vector3d(0, 1, 0));
        Moving inner = new Moving("inner", slow, new Vector3d(), 0, List.of(Sphere.DEFAULT));
        Moving outer = new Moving("outer", fast, new Vector3d(1, 2, 3), 4, List.of(inner));
        Studio studio = Descriptions.with(STUDIO.withScene(List.of(outer)), "lights", List.of(MovingLights.DEFAULT));
        StudioNumber number = StudioNumber.at(place, studio);
        assertThat(number.in(studio)).isCloseTo(value, within(1e-15));
        Studio changed = number.with(studio, next);
        assertThat(number.in(changed)).isEqualTo(next);
        assertThat(changed.velocity()).as("that of the camera").isEqualTo(studio.velocity());
    }

    @Test
    void theSpeedKeepsItsDirection() {
        Studio fast = StudioNumber.speed(SpeedScale.GAMMA).with(STUDIO, 5.0 / 3);
        assertThat(fast.velocity().components().x()).isCloseTo(0.8, within(1e-15));
        assertThat(StudioNumber.at("velocity.gamma", STUDIO)).isEqualTo(StudioNumber.speed(SpeedScale.GAMMA));
        assertThat(StudioNumber.speed(SpeedScale.RAPIDITY).isSpeed()).isTrue();
        assertThat(StudioNumber.OPENING_TIME.isSpeed()).isFalse();
    }

    @Test
    void aVectorIsChangedInOneComponent() {
        Studio moved = StudioNumber.at("scene[1].objects[0].centre.y", STUDIO).with(STUDIO, 7);
        Sphere sphere = (Sphere) ((Group) moved.scene().get(1)).objects().get(0);
        assertThat(sphere.centre())
                .isEqualTo(new Vector3d(
                        Sphere.DEFAULT.centre().x(), 7, Sphere.DEFAULT.centre().z()));
    }

    /** The window that undoes the aberration still undoes it, until it is changed itself. */
    @Test
    void aWindowThatHasTheVelocityOfTheCameraKeepsIt() {
        Studio studio = FrontWindow.with(STUDIO, LorentzWindow.DEFAULT.withVelocity(STUDIO.velocity()));
        Studio faster = StudioNumber.speed(SpeedScale.BETA).with(studio, 0.9);
        assertThat(FrontWindow.of(faster).orElseThrow().velocity())
                .isEqualTo(Velocity.of(SpeedScale.BETA, 0.9, new Vector3d(1, 0, 0)));
        Studio apart =
                StudioNumber.at("cameraFrame[0].surface.velocity.beta", studio).with(studio, 0.1);
        assertThat(apart.velocity()).isEqualTo(STUDIO.velocity());
        assertThat(FrontWindow.of(apart).orElseThrow().velocity().speed()).isEqualTo(0.1);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = ';',
            value = {
                "velocty.beta; number must be the path of a number (the scene has title, topic, remarks, scene, cameraFrame,",
                "velocity; number must be the path of a number (velocity has beta, gamma, rapidity, oneMinusBeta), was velocity",
                "scene; number must be the path of a number (scene has [0] to [1]), was scene",
                "scene[2].radius; number must be the path of a number (scene has [0] to [1]), was scene[2].radius",
                "scene[1].objects[0].centre.w; number must be the path of a number (scene[1].objects[0].centre has x, y, z)",
                "cameraFrame[0]; (cameraFrame is not a number that can change step by step), was cameraFrame[0]",
                "title; (title is not a number that can change step by step), was title",
                "settings.width; (settings.width is not a number that",
                "velocity.beta.x; (velocity.beta is not a number that",
                "scene..x; number must be the path of a number, such as velocity.beta,",
                "scene[99999999999]; number must be the path of a number, such as velocity.beta,",
                "''; number must be the path of a number, such as velocity.beta,",
                "0.9; number must be the path of a number, such as velocity.beta,"
            })
    void otherPlacesAreRefused(String place, String message) {
        assertThatThrownBy(() -> StudioNumber.at(place, STUDIO))
                .isInstanceOf(InvalidPropertyException.class)
                .hasMessageContaining(message);
    }
}
