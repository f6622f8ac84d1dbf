package tompkins.trace;

import static org.assertj.core.api.Assertions.as;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.InstanceOfAssertFactories.STRING;

import java.util.Collections;
import java.util.List;
import java.util.function.UnaryOperator;
import org.joml.Vector3d;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.camera.Camera;
import tompkins.camera.CameraMotion;
import tompkins.camera.ThinLensCamera;
import tompkins.property.Descriptions;
import tompkins.sceneobject.Group;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.shutter.DetectorPlaneShutter;
import tompkins.shutter.FixedPointSurfaceShutter;
import tompkins.shutter.RollingShutter;
import tompkins.shutter.Shutter;
import tompkins.shutter.SweepDirection;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.surface.Clock;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Mirror;

/** Each sentence about a picture, for a scene of which it is true, with numbers that were counted by hand. */
class PlanSentencesTest {

    private static final SceneObject BALL = Sphere.DEFAULT;
    private static final SceneObject WALL =
            new Plane("wall", new Vector3d(0, 0, 10), new Vector3d(0, 0, 1), ColouredSurface.DEFAULT);

    /** A ball at rest before a camera at rest; 64 x 48 pixels. */
    private static final Studio REST = Studio.DEFAULT
            .withScene(List.of(BALL))
            .withSettings(Studio.DEFAULT.settings().withSize(64, 48));

    private static final Studio MOVING = REST.withVelocity(Velocity.of(0, 0, 0.6));

    private static Studio with(Studio studio, UnaryOperator<Camera> change) {
        return studio.withCamera(change.apply(studio.camera()));
    }

    private static Studio with(Studio studio, Shutter shutter) {
        return with(studio, camera -> camera.withShutter(shutter));
    }

    private static Studio wide(Studio studio) {
        return with(studio, camera -> Descriptions.with((ThinLensCamera) camera, "apertureRadius", 0.1));
    }

    private static Arguments says(String name, Studio studio, String sentence) {
        return Arguments.of(Named.of(name, studio), sentence);
    }

    static List<Arguments> sentences() {
        Studio still = REST.withScene(List.of(new Sphere("clock", new Vector3d(0, 0, 9), 1, Clock.DEFAULT)));
        Studio rolling = with(MOVING, camera -> camera.withRollingShutter(new RollingShutter(SweepDirection.DOWN, 6)));
        Studio aside = with(MOVING, camera -> camera.withRollingShutter(new RollingShutter(SweepDirection.RIGHT, 6)));
        Studio exposed = with(MOVING, camera -> camera.withExposureTime(0.5));
        return List.of(
                says(
                        "rest",
                        REST,
                        "The camera is at rest: no change of frame, and every opening time gives the same picture."),
                says("clock", still, "The camera is at rest: no change of frame."),
                says(
                        "Lorentz",
                        MOVING,
                        "The camera moves (gamma 1.25): each ray goes once through the Lorentz transformation, at its last"
                                + " event in the camera frame."),
                says(
                        "Galileo",
                        MOVING.withTransformation(TransformationLaw.GALILEAN),
                        "The camera moves (beta 0.6): each ray goes once through the Galilean transformation, at its last"
                                + " event in the camera frame."),
                says(
                        "no law",
                        MOVING.withTransformation(TransformationLaw.NONE),
                        "The camera's velocity (beta 0.6) is ignored: no change of frame."),
                says("lens", wide(REST), "A wide aperture: the focus decides what is sharp."),
                says(
                        "pinhole",
                        REST,
                        "A pinhole: one point of the lens, everything is sharp; the focus does not matter."),
                says(
                        "pinhole and focus",
                        with(REST, FixedPointSurfaceShutter.DEFAULT),
                        "A pinhole: one point of the lens, everything is sharp; the focus only sets the time."),
                says(
                        "any shutter",
                        REST,
                        "Nothing in the scene changes with time: every shutter model gives this picture, except where a ray"
                                + " never crosses the shutter."),
                says(
                        "origins meet",
                        MOVING,
                        "All light crosses the pinhole at time 0, where the origins of both frames meet: only directions change"
                                + " (aberration), not the point of view."),
                says(
                        "later",
                        with(MOVING, new AperturePlaneShutter(1)),
                        "All light crosses the lens at the same time."),
                says("wide", wide(MOVING), "All light crosses the lens at the same time."),
                says(
                        "elsewhere",
                        with(MOVING, camera -> CameraMotion.shifted(camera, new Vector3d(1, 0, 0))),
                        "All light crosses the lens at the same time."),
                says(
                        "companion",
                        MOVING.withCameraFrame(List.of(BALL)),
                        "All light crosses the lens at the same time."),
                says("lines", rolling, "All light of a line crosses the lens at the same time."),
                says(
                        "exposure",
                        exposed,
                        "At each moment of the exposure all light crosses the lens at the same time."),
                says(
                        "exposed lines",
                        with(rolling, camera -> camera.withExposureTime(0.5)),
                        "At each moment of the exposure all light of a line crosses the lens at the same time."),
                says(
                        "detector",
                        with(MOVING, DetectorPlaneShutter.DEFAULT),
                        "The time at the lens is worked out for each ray: different pixels may see the scene from different"
                                + " places."),
                says(
                        "48 rows",
                        rolling,
                        "The shutter rolls down: each of 48 lines opens 0.125 after the one before it, which costs nothing."),
                says(
                        "64 columns",
                        aside,
                        "The shutter rolls right: each of 64 lines opens 0.0938 after the one before it, which costs"
                                + " nothing."),
                says(
                        "unknown blur",
                        exposed.withSettings(exposed.settings().withSize(1, 48)),
                        "The shutter stays open for 0.5: what is seen in the middle of the picture moves by an unknown length"
                                + " meanwhile, in the worst corner by an unknown length. Each sample has a moment of its own,"
                                + " which costs nothing; blur takes more samples."),
                says(
                        "nothing",
                        REST.withScene(List.of()),
                        "The scene holds no objects: rays that reach it see the background."),
                says("one", REST, "1 primitive in the scene: too few for a tree, a list is faster."),
                says("two", scene(2), "2 primitives in the scene: too few for a tree, a list is faster."),
                says("many", scene(20), "20 primitives in the scene: a bounding-volume tree finds the nearest."),
                says("no companion", REST, "Nothing moves with the camera: only the scene is searched."),
                says(
                        "one companion",
                        REST.withCameraFrame(List.of(BALL)),
                        "1 primitive moves with the camera and is searched first: nothing in the scene can hide it."),
                says(
                        "two companions",
                        REST.withCameraFrame(List.of(BALL, WALL)),
                        "2 primitives move with the camera and are searched first: nothing in the scene can hide them."),
                says("dull", REST, "No mirrors, glass, windows or filters: each ray ends where it hits."),
                says(
                        "mirror",
                        REST.withScene(List.of(
                                        new Plane("", new Vector3d(0, 0, 9), new Vector3d(0, 0, 1), Mirror.DEFAULT)))
                                .withSettings(REST.settings().withMaximumDepth(7)),
                        "Some surfaces send rays on: at most 7 times, and only while these carry at least 1/1024 of the"
                                + " light."));
    }

    private static Studio scene(int balls) {
        return REST.withScene(List.of(new Group("balls", Collections.nCopies(balls, BALL))));
    }

    @ParameterizedTest
    @MethodSource("sentences")
    void sentencesAreTrueOfTheirScene(Studio studio, String sentence) {
        assertThat(RenderPlan.of(studio).sentences()).contains(sentence);
    }

    /** One sentence for each question; the shutter has none in a picture of what is measured. */
    @ParameterizedTest
    @MethodSource("sentences")
    void noQuestionIsAnsweredTwice(Studio studio, String sentence) {
        List<String> sentences = RenderPlan.of(studio).sentences();
        assertThat(List.of(
                        "The camera",
                        "A wide|A pinhole",
                        "All light|At each moment|The time at|Nothing in",
                        ".*primitives? in the scene|The scene holds",
                        ".*with the camera",
                        "No mirrors|Some surfaces"))
                .allSatisfy(beginnings -> assertThat(sentences)
                        .filteredOn(each -> each.matches("(" + beginnings + ").*"))
                        .hasSize(1));
    }

    /** Directions are right up to gamma = 1e6, whether the camera or an object has that speed; then to 8 gamma u. */
    @Test
    void speedsWithoutGuaranteeAreWarnedOf() {
        Velocity right = Velocity.of(SpeedScale.GAMMA, 0.99e6, new Vector3d(0, 0, 1));
        Velocity doubtful = Velocity.of(SpeedScale.GAMMA, 1e7, new Vector3d(0, 0, 1));

        assertThat(List.of(REST.withVelocity(right), past(right)))
                .allSatisfy(
                        studio -> assertThat(RenderPlan.of(studio).warnings()).isEmpty());
        assertThat(List.of(REST.withVelocity(doubtful), past(doubtful))).allSatisfy(studio -> {
            RenderPlan plan = RenderPlan.of(studio);
            assertThat(plan.warnings())
                    .singleElement(as(STRING))
                    .endsWith("gamma 10000000 is above 1000000; directions may be wrong by more than 9e-9 radians");
            assertThat(plan.sentences()).contains("Warning: " + plan.warnings().get(0) + ".");
        });
    }

    private static Studio past(Velocity velocity) {
        return REST.withScene(List.of(new Moving("passing", velocity, new Vector3d(), 0, List.of(BALL))));
    }
}
