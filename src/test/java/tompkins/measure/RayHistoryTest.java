package tompkins.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import tompkins.camera.Camera;
import tompkins.io.FactText;
import tompkins.light.AmbientLight;
import tompkins.light.ColourLaw;
import tompkins.light.PointLight;
import tompkins.light.Pulse;
import tompkins.light.StarCatalogue;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.sceneobject.Box;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Plane;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.Lighting;
import tompkins.studio.StarSky;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.studio.View;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Mirror;
import tompkins.surface.Refractive;
import tompkins.trace.RenderPlan;

/** The numbers are closed formulas, the order is that of the ray. */
class RayHistoryTest {

    private static List<FactText.Line> history(Studio studio, double x, double y) {
        return FactText.SIGNS
                .lines(RayHistory.of(Sighting.of(RenderPlan.of(studio), x, y)))
                .toList();
    }

    private static Stream<String> headings(List<FactText.Line> history) {
        return history.stream().filter(FactText.Line::isHeading).map(FactText.Line::name);
    }

    /** A fact under the last heading that begins like this; null if it is not told. */
    private static String fact(List<FactText.Line> history, String heading, String name) {
        int start = 0;
        for (int i = 0; i < history.size(); i++) {
            start = history.get(i).isHeading() && history.get(i).name().startsWith(heading) ? i : start;
        }
        return history.stream()
                .skip(start + 1)
                .takeWhile(line -> !line.isHeading())
                .filter(line -> line.name().equals(name))
                .map(FactText.Line::value)
                .findFirst()
                .orElse(null);
    }

    /**
     * With beta = 0.8 the camera finds the point of z = 9, t = -9 at gamma (z - beta t) = 27, and light 3 times bluer.
     */
    @Test
    void theEndOfTheRayIsToldInBothFrames() {
        List<FactText.Line> history = history(Studios.sphere().withVelocity(Velocity.of(0, 0, 0.8)), 32, 24);
        assertThat(headings(history))
                .containsExactly(
                        "Starts in the camera frame", "Enters the scene frame", "Hits sphere", "Colour (linear)");
        assertThat(fact(history, "Starts", "position")).isEqualTo("(0, 0, 0)");
        assertThat(fact(history, "Starts", "time")).isEqualTo("0");
        assertThat(fact(history, "Enters", "direction")).isEqualTo("(0, 0, 1)");
        assertThat(fact(history, "Enters", "Doppler factor (camera/scene)")).isEqualTo("3");
        assertThat(fact(history, "Enters", "gamma")).isEqualTo("1.667");
        assertThat(fact(history, "Hits", "distance (scene)")).isEqualTo("9");
        assertThat(fact(history, "Hits", "scene frame")).isEqualTo("(0, 0, 9), time -9");
        assertThat(fact(history, "Hits", "camera frame")).isEqualTo("(0, 0, 27), time -27");
        assertThat(fact(history, "Hits", "throughput")).isNull();
    }

    /** The wall z = 9 - 0.8 t is seen at z = 45, t = -45, its proper time gamma (t + 0.8 (z - 9)) = -27. */
    @Test
    void whatMovesIsToldInItsOwnFrameToo() {
        Plane wall = new Plane("wall", new Vector3d(1, 2, 0), new Vector3d(0, 0, 1), ColouredSurface.DEFAULT);
        Moving moving = new Moving("moving", Velocity.of(0, 0, -0.8), new Vector3d(0, 0, 9), 100, List.of(wall));
        Studio studio = Studios.sphere().withScene(List.of(moving));
        List<FactText.Line> history = history(studio, 32, 24);
        assertThat(fact(history, "Hits wall", "distance (scene)")).isEqualTo("45");
        assertThat(fact(history, "Hits wall", "scene frame")).isEqualTo("(0, 0, 45), time -45");
        assertThat(fact(history, "Hits wall", "rest frame"))
                .startsWith("(0, 0, ")
                .endsWith("), proper time -27, clock reading 73, Doppler factor (camera/object) 3");
        assertThat(fact(history(Studios.sphere(), 32, 24), "Hits sphere", "rest frame"))
                .isNull();
    }

    /** The wall of above, at rest in what moves: its proper time is -27, and both offsets are added. */
    @Test
    void clockOffsetsOfMotionInMotionAddUp() {
        Plane wall = new Plane("wall", new Vector3d(), new Vector3d(0, 0, 1), ColouredSurface.DEFAULT);
        Moving inner = new Moving("inner", Velocity.REST, new Vector3d(), 20, List.of(wall));
        Moving outer = new Moving("outer", Velocity.of(0, 0, -0.8), new Vector3d(0, 0, 9), 100, List.of(inner));
        List<FactText.Line> history = history(Studios.sphere().withScene(List.of(outer)), 32, 24);
        assertThat(fact(history, "Hits wall", "rest frame")).contains("proper time -27, clock reading 93,");
    }

    /** At the time 5 of the camera the wall is at z = 9 - 0.8 x 5, whatever light brings of it. */
    @Test
    void whatIsMeasuredHasNoFrequency() {
        Plane wall = new Plane("wall", new Vector3d(), new Vector3d(0, 0, 1), ColouredSurface.DEFAULT);
        Moving moving = new Moving("moving", Velocity.of(0, 0, -0.8), new Vector3d(0, 0, 9), 0, List.of(wall));
        Studio studio = Studios.sphere().withScene(List.of(moving)).withView(View.MEASURED);
        Camera later = studio.camera().withShutter(studio.camera().shutter().openedAt(5));
        List<FactText.Line> history = history(studio.withCamera(later), 32, 24);
        assertThat(fact(history, "Enters", "Doppler factor (camera/scene)")).startsWith("none: measured");
        assertThat(fact(history, "Hits", "scene frame")).isEqualTo("(0, 0, 5), time 5");
        assertThat(fact(history, "Hits", "rest frame")).endsWith("), proper time 3");
    }

    /** The ball is met at (0, 0, 9), 5 away from the lamp, at time -9: its light left at -14, 3 after a flash began. */
    @Test
    void lightOfAFlashIsToldWithItsTime() {
        PointLight lamp = new PointLight(new Vector3d(0, 3, 5), Colour.WHITE, Colour.WHITE, 1, new Pulse(3, 0.5, 4));
        Studio studio = Lighting.of(Studios.sphere(), List.of(AmbientLight.DEFAULT, PointLight.DEFAULT, lamp));
        assertThat(fact(history(studio, 32, 24), "Hits sphere", "light of lamp 2 left at"))
                .isEqualTo("-14, lamp off, number of the flash -5");
        assertThat(fact(history(studio, 32, 24), "Hits sphere", "light of lamp 1 left at"))
                .isNull();
    }

    /** Light that a camera of the speed 0.5 sees coming from ahead in a medium of index 2 has the speed 0 there. */
    @Test
    void lightThatStandsStillInTheSceneIsNotTheBackground() {
        Plane medium = new Plane("medium", new Vector3d(0, 0, -1), new Vector3d(0, 0, -1), new Refractive(2));
        Studio studio = Studios.sphere()
                .withScene(List.of())
                .withVelocity(Velocity.of(0, 0, 0.5))
                .withTransformation(TransformationLaw.GALILEAN)
                .withCameraFrame(List.of(medium));
        assertThat(headings(history(studio, 32, 24)))
                .containsExactly(
                        "Starts in the camera frame",
                        "No light comes from there: the camera is as fast as light in what is around it, or faster",
                        "Colour (linear)");
        assertThat(headings(history(studio, 33, 24))).contains("Meets nothing else: the background");
    }

    /** What the slab before the lens reflects is told as a weaker branch, and crosses into the scene by itself. */
    @Test
    void weakerBranchesAreMarked() {
        Studio studio = Studios.sphere()
                .withCameraFrame(
                        List.of(new Box("slab", new Vector3d(-5, -5, 2), new Vector3d(5, 5, 3), Refractive.DEFAULT)));
        List<FactText.Line> history = history(studio, 32, 24);
        assertThat(headings(history.stream().filter(line -> line.branch() == 0).toList()))
                .containsExactly(
                        "Starts in the camera frame",
                        "Hits slab",
                        "Hits slab",
                        "Enters the scene frame",
                        "Hits sphere",
                        "Colour (linear)");
        assertThat(history).anyMatch(line -> line.branch() > 0 && line.name().equals("Hits slab"));
        // the last of three ways through it, each 1.5 long in time; both frames are one
        assertThat(fact(history, "Hits slab", "camera frame")).isEqualTo("(0, 0, 3), time -6.5");
        assertThat(fact(history, "Hits slab", "scene frame")).isNull();
    }

    /** What the mirror sends on meets the wall behind the camera. */
    @Test
    void theShareOfARayThatIsNotTheWholeLightIsTold() {
        Vector3d forwards = new Vector3d(0, 0, 1);
        Studio studio = Studio.DEFAULT.withScene(List.of(
                new Plane("near", new Vector3d(0, 0, 5), forwards, new Mirror(0.25)),
                new Plane("far", new Vector3d(0, 0, -5), forwards, ColouredSurface.DEFAULT)));
        List<FactText.Line> history = history(studio, 320, 240);
        assertThat(fact(history, "Hits far", "distance (scene)")).isEqualTo("10");
        assertThat(fact(history, "Hits far", "throughput")).isEqualTo("0.25");
        assertThat(fact(history, "Hits near", "throughput")).isNull();
    }

    /** Ahead at 0.8 c a star is 5 log10 3 magnitudes brighter, and three times as hot. */
    @Test
    void theNearestStarIsTold() {
        StarSky sky = StarSky.DEFAULT;
        Vector3d sirius = sky.direction(StarCatalogue.upTo(-1).get(0));
        Studio studio = Descriptions.with(Studio.DEFAULT, "background", sky)
                .withCamera(Descriptions.with(Studio.DEFAULT.camera(), "viewDirection", sirius));
        List<FactText.Line> atRest = history(studio, 320, 240);
        assertThat(fact(atRest, "Nearest star", "name")).isEqualTo("Sirius");
        assertThat(starNumber(atRest, "magnitude V at rest")).isEqualTo(-1.44);
        assertThat(starNumber(atRest, "right ascension")).isCloseTo(101.2872, withinPercentage(0.1));
        assertThat(starNumber(atRest, "colour temperature at rest")).isCloseTo(10002.2, withinPercentage(0.1));
        assertThat(fact(atRest, "Nearest star", "magnitude as seen")).isNull();

        Velocity velocity = Velocity.of(sirius.mul(0.8, new Vector3d()));
        Studio moving = studio.withVelocity(velocity);
        assertThat(starNumber(history(moving.withColours(ColourLaw.SEARCHLIGHT), 320, 240), "magnitude as seen"))
                .isCloseTo(-1.44 - 5 * Math.log10(3), withinPercentage(0.1));
        assertThat(starNumber(history(moving.withColours(ColourLaw.DOPPLER), 320, 240), "colour temperature as seen"))
                .isCloseTo(30006.6, withinPercentage(0.1));
    }

    /** A camera that looks back to the right ascension 180, and sees stars as bright as Spica. */
    private static Studio towardsSpica() {
        return Descriptions.with(Studio.DEFAULT, "background", Descriptions.with(StarSky.DEFAULT, "limit", 1.0))
                .withCamera(Descriptions.with(Studio.DEFAULT.camera(), "viewDirection", new Vector3d(0, 0, -1)));
    }

    /** Spica, at the right ascension 201.298 and the declination -11.161, is 24 degrees from the ray. */
    @Test
    void aStarBesideTheRayHasItsOwnDopplerFactor() {
        Studio studio = towardsSpica().withVelocity(Velocity.of(SpeedScale.GAMMA, 10, new Vector3d(0, 0, 1)));
        double cosine = Math.cos(Math.toRadians(201.298)) * Math.cos(Math.toRadians(11.161));
        double factor = 10 * (1 + Math.sqrt(0.99) * cosine);
        List<FactText.Line> brighter = history(studio.withColours(ColourLaw.SEARCHLIGHT), 320, 240);
        assertThat(fact(brighter, "Nearest star", "name")).isEqualTo("Spica");
        assertThat(starNumber(brighter, "magnitude as seen"))
                .isCloseTo(0.98 - 5 * Math.log10(factor), withinPercentage(0.1));
        List<FactText.Line> hotter = history(studio.withColours(ColourLaw.DOPPLER), 320, 240);
        assertThat(starNumber(hotter, "colour temperature as seen"))
                .isCloseTo(factor * starNumber(hotter, "colour temperature at rest"), withinPercentage(0.1))
                .isCloseTo(12990, withinPercentage(0.1));
    }

    /** The angle between two directions of the sky, cos a = cos RA cos D, has more digits than are shown. */
    @Test
    void programsGetAllDigitsOfAStar() {
        Map<String, Double> star = starNumbers(towardsSpica());
        double rightAscension = Math.toRadians(star.get("rightAscensionDegrees") - 180);
        double declination = Math.toRadians(star.get("declinationDegrees"));
        assertThat(star.get("separationDegrees"))
                .isCloseTo(Math.toDegrees(Math.acos(Math.cos(rightAscension) * Math.cos(declination))), within(1e-12));
        assertThat(fact(history(towardsSpica(), 320, 240), "Nearest star", "angle to it (scene)"))
                .hasSizeLessThan(8);
    }

    @Test
    void theSearchlightLeavesTemperatures() {
        Studio moving = towardsSpica().withVelocity(Velocity.of(0, 0, 0.8));
        assertThat(starNumbers(moving.withColours(ColourLaw.DOPPLER))).containsKeys("magnitudeSeen", "temperatureSeen");
        assertThat(starNumbers(moving.withColours(ColourLaw.SEARCHLIGHT)))
                .containsKey("magnitudeSeen")
                .doesNotContainKey("temperatureSeen");
    }

    /** What programs are told about the nearest star. */
    private static Map<String, Double> starNumbers(Studio studio) {
        return RayHistory.of(Sighting.of(RenderPlan.of(studio), 320, 240)).stream()
                .filter(fact -> fact.key().equals("nearestStar"))
                .flatMap(star -> Fact.forPrograms(((Fact.Group) star).facts()))
                .filter(Quantity.class::isInstance)
                .collect(Collectors.toMap(Fact::key, number -> ((Quantity) number).value()));
    }

    private static double starNumber(List<FactText.Line> history, String name) {
        return Double.parseDouble(fact(history, "Nearest star", name).split("[ \u00b0]")[0]);
    }
}
