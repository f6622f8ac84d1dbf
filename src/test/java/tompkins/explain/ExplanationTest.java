package tompkins.explain;

import static org.assertj.core.api.Assertions.as;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.InstanceOfAssertFactories.STRING;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvFileSource;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
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
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;
import tompkins.studio.Lighting;
import tompkins.studio.StarSky;
import tompkins.studio.Studio;
import tompkins.surface.ColouredSurface;
import tompkins.surface.IdealLens;
import tompkins.surface.Mirror;
import tompkins.surface.Surface;
import tompkins.surface.TwoSided;
import tompkins.trace.RenderPlan;

/** Each sentence about a picture, for a scene of which it is true, with numbers that were counted by hand. */
class ExplanationTest {

    private static final SceneObject BALL = Sphere.DEFAULT;

    /** A ball at rest before a camera at rest; 64 x 48 pixels. */
    private static final Vector3d ALONG = new Vector3d(0, 0, 1);

    private static final Studio REST = Studio.DEFAULT
            .withScene(List.of(BALL))
            .withSettings(Studio.DEFAULT.settings().withSize(64, 48));

    private static final Studio MOVING = REST.withVelocity(Velocity.of(0, 0, 0.6));

    @ParameterizedTest
    @CsvFileSource(resources = "sentences.csv", delimiter = '|', quoteCharacter = '~')
    void sentencesAreTrueOfTheirScene(String scene, String sentence) {
        assertThat(explained(scene)).contains(sentence);
    }

    /** One sentence for each question; the shutter has none in a picture of what is measured. */
    @ParameterizedTest
    @CsvFileSource(resources = "sentences.csv", delimiter = '|', quoteCharacter = '~')
    void noQuestionIsAnsweredTwice(String scene) {
        List<String> sentences = explained(scene).lines().toList();
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
        String text = scene.replace("WINDOW", "{'type': 'Plane', 'surface': {'type': 'LorentzWindow'}}")
                .replace('\'', '"');
        Studio studio = StudioReader.read(text, "explained.json", Path.of(""));
        Studio small = text.contains("settings")
                ? studio
                : studio.withSettings(studio.settings().withSize(64, 48));
        return String.join("\n", new Explanation(RenderPlan.of(small)).sentences());
    }

    @ParameterizedTest
    @CsvFileSource(resources = "left-out.csv", delimiter = '|', quoteCharacter = '~')
    void tellsWhatIsLeftOutWhereItMatters(String said, String with, String without) {
        assertThat(explained(with)).contains(said);
        assertThat(explained(without)).doesNotContain(said);
    }
}
