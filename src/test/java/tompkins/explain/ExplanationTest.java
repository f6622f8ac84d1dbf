package tompkins.explain;

import static org.assertj.core.api.Assertions.as;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.InstanceOfAssertFactories.STRING;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.camera.Camera;
import tompkins.camera.CameraMotion;
import tompkins.camera.Stereo;
import tompkins.camera.StereoLayout;
import tompkins.camera.ThinLensCamera;
import tompkins.io.StudioReader;
import tompkins.light.AmbientLight;
import tompkins.light.ColourLaw;
import tompkins.light.PointLight;
import tompkins.light.Pulse;
import tompkins.property.Descriptions;
import tompkins.property.NumberText;
import tompkins.ray.Colour;
import tompkins.sceneobject.Box;
import tompkins.sceneobject.Cylinder;
import tompkins.sceneobject.Disc;
import tompkins.sceneobject.Ellipsoid;
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
import tompkins.studio.FrontWindow;
import tompkins.studio.Lighting;
import tompkins.studio.StarSky;
import tompkins.studio.Studio;
import tompkins.surface.Clock;
import tompkins.surface.ColouredSurface;
import tompkins.surface.GalileoWindow;
import tompkins.surface.IdealLens;
import tompkins.surface.LorentzWindow;
import tompkins.surface.Mirror;
import tompkins.surface.Surface;
import tompkins.surface.TwoSided;
import tompkins.trace.RenderPlan;

/** Each sentence about a picture, for a scene of which it is true, with numbers that were counted by hand. */
class ExplanationTest {

    private static final SceneObject BALL = Sphere.DEFAULT;
    private static final SceneObject WALL =
            new Plane("wall", new Vector3d(0, 0, 10), new Vector3d(0, 0, 1), ColouredSurface.DEFAULT);

    /** A ball at rest before a camera at rest; 64 x 48 pixels. */
    private static final Vector3d ALONG = new Vector3d(0, 0, 1);

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

    private static Studio stereo(StereoLayout layout) {
        return with(REST, camera -> camera.withStereo(Stereo.DEFAULT.withLayout(layout)));
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
                        "Each ray crosses the lens at its own time, so pixels can have different viewpoints in the scene."),
                says(
                        "pair",
                        stereo(StereoLayout.SIDE_BY_SIDE),
                        "Stereo, side by side: the eyes rest in the camera frame, 0.3 apart, and both show what is 10"
                                + " straight ahead in the middle of their pictures."),
                says(
                        "anaglyph",
                        stereo(StereoLayout.ANAGLYPH),
                        "Stereo, anaglyph: the eyes rest in the camera frame, 0.3 apart, and both show what is 10 straight"
                                + " ahead in the middle of their pictures. Each sample follows a ray of each eye; the ray that is traced for a point is that"
                                + " of the left eye."),
                says(
                        "eye",
                        stereo(StereoLayout.RIGHT_EYE),
                        "Stereo, right eye: the eyes rest in the camera frame, 0.3 apart, and both show what is 10 straight"
                                + " ahead in the middle of their pictures."),
                says(
                        "48 rows",
                        rolling,
                        "The shutter rolls down: each of 48 lines opens 0.125 after the one before it, which is free."),
                says(
                        "64 columns",
                        aside,
                        "The shutter rolls right: each of 64 lines opens 0.0938 after the one before it, which is free."),
                says(
                        "unknown blur",
                        exposed.withSettings(exposed.settings().withSize(1, 48)),
                        "The shutter stays open for 0.5: what the middle of the picture shows moves by an unknown length"
                                + " meanwhile. This is free; smooth blur needs more samples."),
                says(
                        "nothing",
                        REST.withScene(List.of()),
                        "The scene holds no objects: rays that reach it see the background."),
                says("no companion", REST, "Nothing moves with the camera: only the scene is searched."),
                says(
                        "one companion",
                        REST.withCameraFrame(List.of(BALL)),
                        "1 primitive moves with the camera and is drawn in front of everything in the scene."),
                says(
                        "two companions",
                        REST.withCameraFrame(List.of(BALL, WALL)),
                        "2 primitives move with the camera and are drawn in front of everything in the scene."),
                says(
                        "window that follows",
                        FrontWindow.with(MOVING, LorentzWindow.DEFAULT.withVelocity(MOVING.velocity())),
                        "The window in front of the lens turns light back into the direction that it has in the scene: the"
                                + " aberration is undone."),
                says(
                        "window of another law",
                        FrontWindow.with(MOVING, GalileoWindow.DEFAULT.withVelocity(MOVING.velocity())),
                        "The window in front of the lens turns light as a Galilean change of frame with its own velocity"
                                + " does; the aberration of the camera is not undone."),
                says(
                        "window of another velocity",
                        FrontWindow.with(REST, LorentzWindow.DEFAULT.withVelocity(MOVING.velocity())),
                        "The window in front of the lens turns light as a Lorentz change of frame with its own velocity"
                                + " does."),
                says("dull", REST, "No mirrors, glass, windows or filters: each ray ends where it hits."),
                says(
                        "mirror",
                        REST.withScene(List.of(
                                        new Plane("", new Vector3d(0, 0, 9), new Vector3d(0, 0, 1), Mirror.DEFAULT)))
                                .withSettings(REST.settings().withMaximumDepth(7)),
                        "Some surfaces send rays on: at most 7 times, and only while these carry at least 1/1024 of the"
                                + " light."));
    }

    @ParameterizedTest
    @MethodSource("sentences")
    void sentencesAreTrueOfTheirScene(Studio studio, String sentence) {
        assertThat(new Explanation(RenderPlan.of(studio)).sentences()).contains(sentence);
    }

    /** One sentence for each question; the shutter has none in a picture of what is measured. */
    @ParameterizedTest
    @MethodSource("sentences")
    void noQuestionIsAnsweredTwice(Studio studio, String sentence) {
        List<String> sentences = new Explanation(RenderPlan.of(studio)).sentences();
        assertThat(List.of(
                        "The camera",
                        "A wide|A pinhole",
                        "All light|At each moment|Each ray crosses|Nothing in",
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
                .allSatisfy(studio -> assertThat(new Explanation(RenderPlan.of(studio)).warnings())
                        .isEmpty());
        assertThat(List.of(REST.withVelocity(doubtful), past(doubtful))).allSatisfy(studio -> {
            RenderPlan plan = RenderPlan.of(studio);
            assertThat(new Explanation(plan).warnings())
                    .singleElement(as(STRING))
                    .endsWith("gamma 10000000 is above 1000000; directions may be wrong by more than 9e-9 radians");
            assertThat(new Explanation(plan).sentences())
                    .contains("Warning: " + new Explanation(plan).warnings().get(0) + ".");
        });
    }

    private static Studio past(Velocity velocity) {
        return REST.withScene(List.of(new Moving("passing", velocity, new Vector3d(), 0, List.of(BALL))));
    }

    /** The ball is met at (0, 0, 9), 5 away from the lamp at (0, 3, 5): light is there 14 before the picture. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                    0 | 0.5 | 0 | would be lit with an opening time from 14 to 14.5
                    -20 | 0.5 | 0 | would be lit with an opening time from -6 to -5.5
                    -14 | 0.5 | 0 | is lit with an opening time from 0 to 0.5
                    -1 | 0.5 | 4 | would be lit with an opening time from 1 to 1.5
                    """)
    void saysWhenAFlashIsSeen(double start, double duration, double period, String end) {
        assertThat(new Explanation(RenderPlan.of(flashed(new Pulse(start, duration, period)))).sentences())
                .contains("Lamp 1 flashes for 0.5 at " + NumberText.of(start) + " of its own time"
                        + (period == 0 ? "" : ", and again every 4")
                        + ". The middle of the picture " + end + " (now 0), while it shows that surface.");
    }

    private static Studio flashed(Pulse flash) {
        PointLight lamp = new PointLight(new Vector3d(0, 3, 5), Colour.WHITE, Colour.WHITE, 1, flash);
        return Lighting.of(REST, List.of(AmbientLight.DEFAULT, lamp));
    }

    @Test
    void saysThatNoFlashLightsTheSky() {
        String sentence = "Lamps flash, but the middle of the picture shows nothing that they could light.";
        Studio lit = flashed(new Pulse(-14, 0.5, 0));
        assertThat(new Explanation(RenderPlan.of(lit)).sentences()).doesNotContain(sentence);
        assertThat(new Explanation(RenderPlan.of(lit.withScene(List.of()))).sentences())
                .contains(sentence);
        assertThat(new Explanation(RenderPlan.of(REST.withScene(List.of()))).sentences())
                .doesNotContain(sentence);
    }

    @Test
    void warnsOfFlashesThatLightNothing() {
        assertThat(new Explanation(RenderPlan.of(flashed(new Pulse(1, 0.5, 0)))).warnings())
                .singleElement(as(STRING))
                .startsWith("no flash lights anything in the picture at this opening time: something is lit with");
        assertThat(new Explanation(RenderPlan.of(flashed(new Pulse(-14, 0.5, 0)))).warnings())
                .isEmpty();
        Studio lit = Lighting.of(REST, List.of(PointLight.DEFAULT, (PointLight)
                flashed(new Pulse(1, 0.5, 0)).lights().get(1)));
        assertThat(new Explanation(RenderPlan.of(lit)).warnings()).isEmpty();
    }

    static Stream<Arguments> lenses() {
        Surface hidden = new TwoSided(ColouredSurface.DEFAULT, IdealLens.DEFAULT);
        return Stream.of(
                Arguments.of(new Sphere("ball", new Vector3d(0, 0, 10), 1, IdealLens.DEFAULT), true),
                Arguments.of(new Cylinder("rod", new Vector3d(), ALONG, 1, true, hidden), true),
                Arguments.of(new Ellipsoid("egg", new Vector3d(), new Vector3d(1, 2, 3), Mirror.DEFAULT), false),
                Arguments.of(new Disc("disc", new Vector3d(0, 0, 10), ALONG, 1, IdealLens.DEFAULT), false),
                Arguments.of(new Plane("plane", new Vector3d(0, 0, 10), ALONG, IdealLens.DEFAULT), false),
                Arguments.of(new Box("box", new Vector3d(-1, -1, 9), new Vector3d(1, 1, 10), hidden), false));
    }

    @ParameterizedTest
    @MethodSource("lenses")
    void warnsOfIdealLensesThatAreRound(SceneObject object, boolean isRound) {
        String warning = "an IdealLens is for flat objects; \"" + object.description()
                + "\" is round, and what is seen through it means nothing";
        List<SceneObject> objects = List.of(object);
        Stream.of(REST.withScene(objects), REST.withScene(List.of()).withCameraFrame(objects))
                .map(studio -> new Explanation(RenderPlan.of(studio)).warnings())
                .forEach(warnings -> assertThat(warnings).isEqualTo(isRound ? List.of(warning) : List.of()));
    }

    @Test
    void starsAreCounted() {
        Studio stars = Descriptions.with(MOVING, "background", StarSky.DEFAULT);
        assertThat(new Explanation(RenderPlan.of(stars)).sentences())
                .anyMatch(sentence -> sentence.startsWith("The sky holds 5044 stars, to magnitude 6 at rest")
                        && sentence.endsWith("Motion moves them and leaves them as bright as they are."));
        assertThat(new Explanation(RenderPlan.of(stars.withColours(ColourLaw.SEARCHLIGHT))).sentences())
                .anyMatch(sentence -> sentence.contains("brighter with the square of the Doppler factor D."))
                .anyMatch(sentence -> sentence.contains("Stars that are fainter at rest are left out"));
        assertThat(new Explanation(RenderPlan.of(MOVING)).sentences()).noneMatch(sentence -> sentence.contains("star"));
    }

    /** What is said of a scene, in single quotes, whose window turns light as a change of frame does. */
    private static String explained(String scene) {
        String text = "{" + (scene == null ? "" : scene) + "}";
        String whole = text.replace("WINDOW", "{'type': 'Plane', 'surface': {'type': 'LorentzWindow'}}");
        Studio studio = StudioReader.read(whole.replace('\'', '"'), "explained.json", Path.of(""));
        return String.join("\n", new Explanation(RenderPlan.of(studio)).sentences());
    }

    /** What needs no focus says nothing of a missing one. */
    @ParameterizedTest
    @CsvSource(
            nullValues = "nothing",
            delimiter = '|',
            value = {
                "'apertureRadius': 0, 'shutter': {'type': 'AperturePlaneShutter'}   | nothing",
                "'apertureRadius': 0.1, 'shutter': {'type': 'AperturePlaneShutter'} | everything is focused at infinity.",
                "'apertureRadius': 0, 'shutter': {'type': 'FocusSurfaceShutter'}    | no ray crosses the shutter.",
                "'apertureRadius': 0.1, 'shutter': {'type': 'FixedPointSurfaceShutter'} | no ray crosses the shutter."
            },
            quoteCharacter = '~')
    void warnsOfAFocusWithoutSurface(String camera, String warning) {
        for (String focus : new String[] {"{'type': 'Group'}", "{'type': 'Hidden'}", "{'type': 'Sphere'}"}) {
            String out = explained("'camera': {'focus': " + focus + ", " + camera + "}");

            boolean warns = warning != null && !focus.contains("Sphere");
            assertThat(out.contains("Warning: the focus has no surface")).isEqualTo(warns);
            assertThat(out).contains(warns ? "so that " + warning : "except where a ray never crosses the shutter");
        }
    }

    /** What a scene needs for a sentence about what is left out, and the same scene without that. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '~', textBlock = """
            not the right positions: through a wide aperture | 'cameraFrame': [WINDOW], 'camera': {'apertureRadius': 0.1} \
            | 'cameraFrame': [WINDOW]
            not the right positions: with a shutter that opens at different times | 'velocity': [0, 0, 0.5], 'cameraFrame': [WINDOW], \
            'camera': {'shutter': {'type': 'DetectorPlaneShutter'}} | 'velocity': [0, 0, 0.5], 'cameraFrame': [WINDOW]
            not the right positions | 'scene': [{'type': 'Plane', 'surface': {'type': 'Tiling', 'second': {'type': 'GalileoWindow'}}}], \
            'camera': {'apertureRadius': 0.1} | 'scene': [{'type': 'Plane'}], 'camera': {'apertureRadius': 0.1}
            leave its frequency as it is | 'velocity': [0, 0, 0.5], 'colours': 'doppler', 'cameraFrame': [WINDOW] \
            | 'velocity': [0, 0, 0.5], 'colours': 'doppler'
            do nothing else to it: IdealLens. A wave would be delayed | 'scene': [{'type': 'Disc', 'surface': {'type': 'IdealLens'}}] \
            | 'scene': [{'type': 'Disc'}]
            do nothing else to it: ConfocalLensletArray. | 'cameraFrame': [{'type': 'Disc', 'surface': {'type': 'Tiling', \
            'second': {'type': 'ConfocalLensletArray'}}}] | 'cameraFrame': [WINDOW]
            and a part of it mirrored | 'scene': [{'type': 'Disc', 'surface': {'type': 'ComplexRefraction'}}] \
            | 'scene': [{'type': 'Disc', 'surface': {'type': 'Refractive'}}]
            The focus ignores windows, glass and mirrors | 'cameraFrame': [WINDOW], 'camera': {'apertureRadius': 0.1} \
            | 'cameraFrame': [WINDOW]
            Image points ignore the objects that move with the camera | 'cameraFrame': [WINDOW], \
            'scene': [{'type': 'Group', 'objects': [{'type': 'ImagePointGrid'}]}] | 'cameraFrame': [WINDOW], 'scene': [{'type': 'Sphere'}]
            Lamps do not get fainter with distance. | 'scene': [{'type': 'Sphere'}] \
            | 'scene': [{'type': 'Sphere'}], 'lights': [{'type': 'AmbientLight'}]
            glass and windows throw no shadow | 'scene': [{'type': 'Sphere', 'surface': {'type': 'Refractive'}}] \
            | 'scene': [{'type': 'Sphere'}]
            Ambient light is the same in every frame | 'scene': [{'type': 'Moving', 'velocity': [0, 0, 0.5]}], 'colours': 'doppler' \
            | 'scene': [{'type': 'Sphere'}], 'velocity': [0, 0, 0.5], 'colours': 'doppler'
            no cos^4 law | | 'camera': {'type': 'PanoramicCamera'}
            nothing is blurred by motion | 'velocity': [0, 0, 0.5] | 'velocity': [0, 0, 0]
            nothing is blurred by motion | 'velocity': [0, 0, 0.5] | 'velocity': [0, 0, 0.5], 'camera': {'exposureTime': 1}
            nothing is blurred by motion | 'scene': [{'type': 'Moving'}] | 'scene': [{'type': 'Moving', 'velocity': [0, 0, 0]}]
            Measured, not a photograph: it shows where things are at the time 0 of | 'view': 'measured' | 'view': 'seen'
            where things are in the camera's frame, for each ray | 'view': 'measured', \
            'camera': {'rollingShutter': {'sweep': 1}} | 'view': 'measured'
            no searchlight effect; what is measured has no Doppler | 'view': 'measured', 'colours': 'doppler', 'velocity': [0, 0, 0.5] \
            | 'view': 'measured', 'velocity': [0, 0, 0.5]
            All light crosses the | 'velocity': [0, 0, 0.5] | 'view': 'measured', 'velocity': [0, 0, 0.5]
            """)
    void tellsWhatIsLeftOutWhereItMatters(String said, String with, String without) {
        assertThat(explained(with)).contains(said);
        assertThat(explained(without)).doesNotContain(said);
    }

    /** Two velocities beside rest: what has one of them shares a frame, wherever it is. */
    @Test
    void tellsTheFramesAndTheFastest() {
        String said = explained("""
                'scene': [
                  {'type': 'Sphere'},
                  {'type': 'Moving', 'velocity': [0.6, 0, 0]},
                  {'type': 'Moving', 'velocity': [0.6, 0, 0], 'place': [5, 0, 0]},
                  {'type': 'Moving', 'velocity': [0, 0.8, 0],
                   'objects': [{'type': 'Moving', 'velocity': [0.6, 0, 0]}]}],
                'lights': [{'type': 'AmbientLight'}, {'type': 'PointLight'}, {'type': 'Moving', 'velocity': [0.6, 0, 0]}]
                """);
        assertThat(said)
                .contains(
                        "4 inertial frames: each ray is searched for in every one that holds objects; the fastest moves"
                                + " with gamma 1.667.");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            doppler     | lorentz  | 0.6    | shift with the Doppler factor D (frequency in the camera/scene), as in the light of a black body. The light of \
            the scene is metered in the middle of the picture, where D is 2: -3.1 stops.
            searchlight | lorentz  | 0.6    | The searchlight effect alone: brightness changes with the fourth power of the \
            Doppler factor D (frequency in the camera/scene). The light of the scene is metered in the middle of the picture, where D is 2: -4.0 stops.
            searchlight | lorentz  | 1e-12  | where D is 1: +0.0 stops.
            searchlight | lorentz  | -0.999 | Warning: the light of the scene is too faint to be seen in the middle of the picture, which stays dark.
            doppler     | galilean | 0.6    | no searchlight effect; they change under the Lorentz transformation only.
            doppler     | none     | 0.6    | no searchlight effect; they change under the Lorentz transformation only.
            doppler     | lorentz  | 0      | no Doppler shift, no searchlight effect.
            unchanged   | lorentz  | 0.6    | no Doppler shift, no searchlight effect.
            """)
    void tellsWhatBecomesOfColours(String colours, String law, double speed, String said) {
        assertThat(explained(String.format(
                        Locale.ROOT,
                        "'colours': '%s', 'transformation': '%s', 'velocity': [0, 0, %s]",
                        colours,
                        law,
                        speed)))
                .contains(said);
    }

    @Test
    void tellsThatLightIsNotMetered() {
        assertThat(explained("'colours': 'searchlight', 'velocity': [0, 0, 0.6], 'metering': 'none'"))
                .contains("The light of the scene is taken as it comes, without metering.");
    }
}
