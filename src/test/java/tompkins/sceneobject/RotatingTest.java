package tompkins.sceneobject;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.stream.Stream;
import org.joml.Vector2i;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.property.InvalidPropertyException;
import tompkins.spacetime.Velocity;
import tompkins.surface.Blinking;
import tompkins.surface.Clock;
import tompkins.surface.ColouredSurface;
import tompkins.surface.ConfocalLensletArray;
import tompkins.surface.GalileoWindow;
import tompkins.surface.IdealLens;
import tompkins.surface.LorentzWindow;
import tompkins.surface.Mirror;
import tompkins.surface.Refractive;
import tompkins.surface.Surface;

/** What may turn, and how fast. */
class RotatingTest {

    private static final ColouredSurface DULL = ColouredSurface.DEFAULT;
    private static final Vector3d UP = new Vector3d(0, 1, 0);

    private static Rotating turning(double angularSpeed, SceneObject object) {
        return new Rotating("wheel", new Vector3d(), UP, angularSpeed, 0, List.of(object));
    }

    private static Sphere ball(Surface surface) {
        return new Sphere("ball", new Vector3d(1, 5, 0), 0.5, surface);
    }

    /** Each shape with the distance of its farthest point from the y axis. */
    static Stream<Arguments> reaches() {
        Vector3d right = new Vector3d(2, 0, 0);
        return Stream.of(
                Arguments.of(ball(DULL), 1.5),
                Arguments.of(new Box("box", new Vector3d(-1, 0, -3), new Vector3d(2, 9, 1), DULL), Math.sqrt(13)),
                // the far rim is a circle: no box around it counts
                Arguments.of(new Cylinder("rod", new Vector3d(), right, 0.5, true, DULL), Math.sqrt(4.25)),
                Arguments.of(new Cylinder("axle", new Vector3d(1, 0, 0), new Vector3d(1, 4, 0), 0.5, true, DULL), 1.5),
                Arguments.of(new Cone("cone", right, new Vector3d(), 1, true, DULL), 2),
                Arguments.of(new Disc("disc", right, new Vector3d(0, 3, 4), 1, DULL), farthestOfTiltedDisc()),
                // the square is (2 + cos)^2 + (3 sin)^2, greatest for cos 1/4
                Arguments.of(new Ellipsoid("egg", right, new Vector3d(1, 2, 3), DULL), Math.sqrt(13.5)),
                // half a ball that bulges outwards, and one that bulges inwards and has its rim outside
                Arguments.of(new Lens("dome", right, right, 0.5, 0, 2, 0, DULL), 2.5),
                Arguments.of(new Lens("bowl", right, right, 0.5, 0, 0, 2, DULL), Math.sqrt(4.25)),
                Arguments.of(new Triangle("triangle", right, UP, new Vector3d(0, 0, -4), DULL), 4));
    }

    /** Tilted about x: the square of the distance is (2 + cos)^2 + (0.6 sin)^2, which is greatest for cos 1. */
    private static double farthestOfTiltedDisc() {
        return 3;
    }

    @ParameterizedTest
    @MethodSource("reaches")
    void everyPointIsSlowerThanLight(SceneObject object, double reach) {
        assertThat(turning((1 - 1e-9) / reach, object).moves()).isTrue();
        assertThat(turning((-1 + 1e-9) / reach, object).moves()).isTrue();
        assertThatThrownBy(() -> turning(1 / reach, object))
                .isInstanceOf(InvalidPropertyException.class)
                .hasMessageContaining("angularSpeed must be so slow that every point of \"" + object.description());
    }

    static Stream<SceneObject> refused() {
        return Stream.of(
                Plane.DEFAULT,
                Moving.DEFAULT,
                Rotating.DEFAULT,
                new Group("group", List.of(Plane.DEFAULT)),
                new ImagePointGrid("grid", ball(DULL), UP, UP, new Vector3d(1, 0, 0), new Vector2i(2, 2)),
                ball(Refractive.DEFAULT),
                ball(LorentzWindow.DEFAULT),
                ball(GalileoWindow.DEFAULT),
                ball(new Clock(1, DULL, Refractive.DEFAULT, false)),
                ball(new Blinking(1, DULL, LorentzWindow.DEFAULT)));
    }

    @ParameterizedTest
    @MethodSource("refused")
    void onlyBoundedRestingOpaqueThingsTurn(SceneObject object) {
        assertThatThrownBy(() -> turning(0.01, object))
                .isInstanceOf(InvalidPropertyException.class)
                .hasMessageStartingWith("objects must be")
                .hasMessageContaining(object.description());
    }

    static Stream<Surface> sheets() {
        return Stream.of(Mirror.DEFAULT, ConfocalLensletArray.DEFAULT, IdealLens.DEFAULT);
    }

    @ParameterizedTest
    @MethodSource("sheets")
    void mirrorsAndLensesTurn(Surface sheet) {
        assertThat(turning(0.5, ball(sheet)).primitiveCount()).isEqualTo(1);
    }

    /** In what moves it turns, and in what is placed; a wheel of another size has the same speed at its rim. */
    @Test
    void wheelsMayMoveAndBePlaced() {
        Rotating wheel = turning(0.6, ball(DULL));
        Moving rolling = new Moving("", Velocity.of(0.6, 0, 0), new Vector3d(), 0, List.of(wheel));
        Placed large = new Placed("", wheel, 100, UP, 30, UP);

        assertThat(List.of(rolling, large)).allMatch(SceneObject::moves);
        assertThat(new Hidden(wheel).moves()).isFalse();
    }
}
