package tompkins.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.lesson.AngleBetween;
import tompkins.lesson.DifferenceOf;
import tompkins.lesson.LessonControl;
import tompkins.lesson.Measurement;
import tompkins.lesson.PictureEdge;
import tompkins.lesson.PicturePoint;
import tompkins.lesson.RatioOf;
import tompkins.lesson.RayReading;
import tompkins.lesson.RayValue;
import tompkins.lesson.WithNumber;
import tompkins.property.InvalidPropertyException;
import tompkins.ray.Colour;
import tompkins.sceneobject.Box;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.studio.Studio;
import tompkins.surface.ColouredSurface;
import tompkins.surface.LuminousSurface;
import tompkins.trace.RenderPlan;

class ExperimentTest {

    private static final PictureEdge LEFT = new PictureEdge(0, 0.5, 1, 0.5, 1);
    private static final PictureEdge RIGHT = new PictureEdge(1, 0.5, 0, 0.5, 1);

    private static Studio with(SceneObject... objects) {
        return Studio.DEFAULT.withScene(List.of(objects));
    }

    private static Box wall(double halfWidth) {
        return new Box(
                "wall",
                new Vector3d(-halfWidth, -1, 5),
                new Vector3d(halfWidth, 1, 6),
                new LuminousSurface(Colour.grey(0.5), true));
    }

    private static double measure(Studio studio, Measurement measurement) {
        return new Experiment(studio, LessonControl.DEFAULT).measure(measurement, "here");
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.01, 0.1, 0.4})
    void edgesOfAWallAreFoundToTheLastDigits(double halfWidth) {
        Studio studio = with(wall(halfWidth));
        assertThat(measure(studio, new AngleBetween(LEFT, RIGHT)))
                .isCloseTo(2 * Math.toDegrees(Math.atan(halfWidth / 5)), within(1e-9));
        assertThat(measure(
                        studio, new DifferenceOf(new RayReading(RIGHT, RayValue.X), new RayReading(LEFT, RayValue.X))))
                .isCloseTo(2 * halfWidth, within(1e-9));
    }

    @Test
    void shadingIsNoEdgeAndAJumpOfColourIsOne() {
        Studio ball = with(new Sphere("ball", new Vector3d(0, 0, 8), 0.6, ColouredSurface.DEFAULT));
        assertThat(edges(ball)).hasSize(2);
        Studio hidden = with(
                wall(0.4),
                new Box(
                        "stripe",
                        new Vector3d(-0.2, -1, 4.9),
                        new Vector3d(0.3, 1, 5),
                        new LuminousSurface(Colour.grey(0.6), true)));
        assertThat(edges(hidden)).hasSize(4);
    }

    private static List<Vector2dc> edges(Studio studio) {
        return new Edges(RenderPlan.of(studio)).on(new Vector2d(0, 240), new Vector2d(640, 240), 100);
    }

    @Test
    void otherPicturesAreThoseOfAnotherNumber() {
        Studio studio = with(wall(0.4));
        Measurement middle = new RayReading(PicturePoint.DEFAULT, RayValue.TIME);
        Measurement later = new WithNumber("camera.shutter.openingTime", 2.5, middle);
        assertThat(measure(studio, new DifferenceOf(later, middle))).isCloseTo(2.5, within(1e-12));
        Measurement ratio = new WithNumber("velocity.beta", 0.6, RayReading.DEFAULT);
        assertThat(measure(studio, new RatioOf(ratio, RayReading.DEFAULT))).isCloseTo(2, within(1e-12));
    }

    @Test
    void brightnessIsLinear() {
        Studio studio = with(wall(0.4));
        assertThat(measure(studio, new RayReading(PicturePoint.DEFAULT, RayValue.BRIGHTNESS)))
                .isCloseTo(0.5, within(1e-12));
    }

    @ParameterizedTest
    @EnumSource(names = {"X", "Y", "Z", "TIME", "OWN_TIME"})
    void nothingHasNoPlaceAndNoTime(RayValue value) {
        assertThatThrownBy(() -> measure(with(), new RayReading(PicturePoint.DEFAULT, value)))
                .isInstanceOf(InvalidPropertyException.class)
                .hasMessage("here: point must be where an object is seen, was one where none is");
    }

    @Test
    void whatCannotBeMeasuredIsToldInOneSentence() {
        assertThatThrownBy(() -> measure(with(), new RayReading(LEFT, RayValue.X)))
                .hasMessage("here: count must be that of an edge, and there is none on this way, was 1");
        assertThatThrownBy(
                        () -> measure(with(wall(0.4)), new RayReading(new PictureEdge(0, 0.5, 1, 0.5, 3), RayValue.X)))
                .hasMessage("here: count must be at most 2, for there are no more edges on this way, was 3");
        Measurement zero = new DifferenceOf(RayReading.DEFAULT, RayReading.DEFAULT);
        assertThatThrownBy(() -> measure(with(), new RatioOf(RayReading.DEFAULT, zero)))
                .hasMessage("here must be one that has a value in this picture, was Infinity");
        assertThatThrownBy(() -> measure(with(), new WithNumber("scene", 1, RayReading.DEFAULT)))
                .hasMessageStartingWith("here: number must be the path of a number");
    }
}
