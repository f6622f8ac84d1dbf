package tompkins.trace;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.util.Collections;
import java.util.List;
import java.util.stream.Stream;
import org.joml.Vector2i;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.camera.FocusDistance;
import tompkins.camera.ThinLensCamera;
import tompkins.property.Descriptions;
import tompkins.property.InvalidPropertyException;
import tompkins.sceneobject.Group;
import tompkins.sceneobject.Hidden;
import tompkins.sceneobject.ImagePointGrid;
import tompkins.sceneobject.SampleShapes;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.sceneobject.TriangleMesh;
import tompkins.studio.Studio;
import tompkins.surface.ColouredSurface;

class UsableObjectsTest {

    private static final ColouredSurface COLOURED = ColouredSurface.DEFAULT;
    private static final Sphere BALL = Sphere.DEFAULT;

    /** Objects of a size, 3 sizes in front of the camera. */
    private static List<SceneObject> ofSize(double size) {
        return SampleShapes.all(new Vector3d(0, 0, 3 * size), size, COLOURED).toList();
    }

    static Stream<SceneObject> tooLarge() {
        return ofSize(4e307).stream();
    }

    @ParameterizedTest
    @MethodSource
    void tooLarge(SceneObject object) {
        Studio inScene = Studio.DEFAULT.withScene(List.of(Sphere.DEFAULT, object));
        assertThatExceptionOfType(InvalidPropertyException.class)
                .isThrownBy(() -> RenderPlan.of(inScene))
                .withMessage(
                        "scene[1] must be of a size that can be worked with (lengths from 1e-50 to 1e50 always can), was \""
                                + object.description() + "\"");
        Studio withCamera = Studio.DEFAULT.withCameraFrame(List.of(object));
        assertThatExceptionOfType(InvalidPropertyException.class)
                .isThrownBy(() -> RenderPlan.of(withCamera))
                .withMessageStartingWith("cameraFrame[0] ");
        assertThatExceptionOfType(InvalidPropertyException.class)
                .isThrownBy(() -> focusedOn(object))
                .withMessageStartingWith("focus must be of a size that can be worked with");
    }

    @Test
    @Timeout(value = 600, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
    void copiesOfCopiesAreCountedBeforeTheyAreMade() {
        Studio inScene = Studio.DEFAULT.withScene(List.of(BALL, millionOf(millionOf(BALL))));
        assertThatExceptionOfType(InvalidPropertyException.class)
                .isThrownBy(() -> RenderPlan.of(inScene))
                .withMessage("scene[1] must be small enough for at most 10000000 primitives in all,"
                        + " was \"copies\" with 1e12 (after 1)");
        // an octahedron has 8 triangles
        Studio withCamera = Studio.DEFAULT.withCameraFrame(List.of(
                millionOf(TriangleMesh.DEFAULT), millionOf(new Group("", List.of(BALL, Hidden.DEFAULT, BALL, BALL)))));
        assertThatExceptionOfType(InvalidPropertyException.class)
                .isThrownBy(() -> RenderPlan.of(withCamera))
                .withMessageStartingWith("cameraFrame[1] ")
                .withMessageEndingWith(" with 3000000 (after 8000000)");
    }

    @Test
    @Timeout(value = 600, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
    void copiesOfCopiesOfNothingAreNothing() {
        Studio studio = Studio.DEFAULT.withScene(List.of(millionOf(millionOf(Hidden.DEFAULT))));
        assertThat(SampleHistory.of(RenderPlan.of(studio), 320.5, 239.5, 0, 0).hits())
                .isEmpty();
    }

    @Test
    void aFocusHasNoMorePrimitivesThanAScene() {
        assertThatExceptionOfType(InvalidPropertyException.class)
                .isThrownBy(() -> focusedOn(millionOf(new Group("", Collections.nCopies(11, BALL)))))
                .withMessage("focus must be a surface of at most 10000000 primitives, was 11000000");
    }

    private static ThinLensCamera focusedOn(SceneObject focus) {
        return Descriptions.with(ThinLensCamera.DEFAULT, "focus", focus);
    }

    private static SceneObject millionOf(SceneObject object) {
        Vector3d corner = new Vector3d(-1, -1, 10);
        return new ImagePointGrid(
                "copies", object, corner, new Vector3d(2, 0, 0), new Vector3d(0, 2, 0), new Vector2i(1000, 1000));
    }

    static Stream<SceneObject> usable() {
        return Stream.of(1e-50, 1e50).flatMap(size -> ofSize(size).stream());
    }

    /** What is seen does not depend on the unit of length. */
    @ParameterizedTest
    @MethodSource
    void usable(SceneObject object) {
        SampleHistory life =
                SampleHistory.of(RenderPlan.of(Studio.DEFAULT.withScene(List.of(object))), 320.5, 239.5, 0, 0);
        assertThat(life.hits()).hasSize(1);
        assertThat(life.hits().get(0).event().position().isFinite()).isTrue();
        assertThat(1 / FocusDistance.of(focusedOn(object))).isFinite().isNotZero();
    }

    @Test
    void aLampCannotBeTooFarFromTheObjects() {
        Studio studio = Studio.DEFAULT.withScene(List.of(new Sphere("far", new Vector3d(0, 0, 1e308), 1, COLOURED)));
        assertThatExceptionOfType(InvalidPropertyException.class)
                .isThrownBy(() -> RenderPlan.of(studio))
                .withMessageStartingWith("scene must be of a size that can be worked with");
    }
}
