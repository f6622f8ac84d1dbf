package tompkins.scenes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.explain.Explanation;
import tompkins.image.LinearImage;
import tompkins.light.Star;
import tompkins.light.StarCatalogue;
import tompkins.property.Descriptions;
import tompkins.sceneobject.Cylinder;
import tompkins.spacetime.Velocity;
import tompkins.studio.RideLeg;
import tompkins.studio.RideMoment;
import tompkins.studio.StarSky;
import tompkins.studio.Studio;
import tompkins.surface.Refractive;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;
import tompkins.world.FrameAppearance;

/** What the scenes of the topic Stars, and the ride among them, tell in their remarks. */
class StarScenesTest {

    private static final Map<String, Star> NAMED =
            StarCatalogue.names().entrySet().stream().collect(Collectors.toMap(Map.Entry::getValue, Map.Entry::getKey));

    private static StarSky sky(Studio studio) {
        return (StarSky) studio.background();
    }

    private static Vector3d look(Studio studio, Star star) {
        return new FrameAppearance(studio, null).look(sky(studio).direction(star));
    }

    private static double dopplerFactor(Studio studio, Star star) {
        return new FrameAppearance(studio, null).dopplerFactorAlong(sky(studio).direction(star));
    }

    /** East is to the left, north is up. */
    @Test
    void theSkyIsNotMirrored() {
        Studio studio = SceneFiles.read("stars-00");
        Vector3d sirius = look(studio, NAMED.get("Sirius"));
        assertThat(sirius.x).isNegative();
        assertThat(sirius.y).isNegative();
        Vector3d aldebaran = look(studio, NAMED.get("Aldebaran"));
        assertThat(aldebaran.x).isPositive();
        assertThat(aldebaran.y).isPositive();
        assertThat(StarCatalogue.upTo(sky(studio).limit())).hasSize(5044);
    }

    /** tan(a'/2) = tan(a/2) sqrt((1 - v)/(1 + v)) for a = 90 degrees, and the Doppler factor straight ahead. */
    @ParameterizedTest
    @CsvSource({"stars-05, 0.5, 60, 1.7", "stars-09, 0.9, 25.84, 4.36", "stars-099, 0.99, 8.11, 14.1"})
    void halfOfTheSkyFitsIntoACircle(String scene, double speed, double degrees, double factor) {
        Studio studio = SceneFiles.read(scene);
        assertThat(studio.velocity().speed()).isEqualTo(speed);
        List<Star> stars = StarCatalogue.upTo(sky(studio).limit());
        double cosine = Math.cos(Math.toRadians(degrees));
        long inside =
                stars.stream().filter(star -> look(studio, star).z > cosine).count();
        long ahead =
                stars.stream().filter(star -> sky(studio).direction(star).z > 0).count();
        assertThat((double) inside).isCloseTo(ahead, within(12.0));
        double most = stars.stream()
                .mapToDouble(star -> dopplerFactor(studio, star))
                .max()
                .orElseThrow();
        assertThat(most).isCloseTo(factor, within(0.04));
    }

    @Test
    void betelgeuseIsWhiteAtHalfTheSpeedOfLight() {
        Star star = NAMED.get("Betelgeuse");
        double temperature = star.temperature() * dopplerFactor(SceneFiles.read("stars-05"), star);
        // white on a screen is a black body of 6504 K
        assertThat(temperature).isCloseTo(6504, within(100.0));
    }

    @Test
    void nearlyAllStarsCrowdAheadAtTheHighestSpeed() {
        Studio studio = SceneFiles.read("stars-099");
        List<Star> stars = StarCatalogue.upTo(sky(studio).limit());
        double cosine = Math.cos(Math.toRadians(30));
        long inside =
                stars.stream().filter(star -> look(studio, star).z > cosine).count();
        assertThat((double) inside / stars.size()).isBetween(0.9, 0.96);
    }

    /** x = (cosh(g T) - 1)/g, t = sinh(g T)/g in years and light years, with g = 9.80665 m/s^2. */
    @Test
    void theRideTakesTheYearsThatItsRemarksTell() {
        Studio studio = SceneFiles.read("stars-ride");
        double gravity = 9.80665 * 365.25 * 86400 / 299792458;
        RideMoment moment = RideMoment.start(studio);
        double fastest = 0;
        double onBoard = 0;
        double underThrust = 0;
        for (RideLeg leg : studio.ride()) {
            double before = moment.sceneTime();
            moment = moment.after(leg, leg.properTime());
            fastest = Math.max(fastest, moment.rider().velocity().speed());
            if (leg.acceleration().length() > 0) {
                assertThat(leg.acceleration().length()).isCloseTo(gravity, within(1e-5));
                onBoard += leg.properTime();
                underThrust += moment.sceneTime() - before;
            }
        }
        double half = onBoard / 2;
        assertThat(onBoard).isCloseTo(3.58, within(0.01));
        assertThat(underThrust).isCloseTo(6.0, within(0.01));
        assertThat(underThrust).isCloseTo(2 * Math.sinh(gravity * half) / gravity, within(1e-4));
        assertThat(2 * (Math.cosh(gravity * half) - 1) / gravity).isCloseTo(4.37, within(0.001));
        assertThat(moment.rider().event().position().z()).isCloseTo(4.37, within(0.001));
        assertThat(fastest).isCloseTo(0.95, within(0.005));
        assertThat(moment.rider().velocity().speed()).isLessThan(1e-3);
        Vector3d ahead = look(studio, NAMED.get("Rigil Kentaurus"));
        assertThat(ahead.z).isGreaterThan(0.999999);
    }

    /**
     * Airy 1871: a star abeam is seen at (beta, 0, 1/gamma), and a telescope that points there has it in the middle,
     * with and without water. Elsewhere sin(a) = sin(a')/n.
     */
    @ParameterizedTest
    @CsvSource({"0, 1", "0, 1.3333333333333333", "0.6, 1", "0.6, 1.3333333333333333", "0.96, 1.3333333333333333"})
    void waterMovesNoStarInTheMiddle(double speed, double index) {
        Vector3d ahead = new Vector3d(speed, 0, Math.sqrt(1 - speed * speed));
        Studio studio = telescope(ahead, index);
        RenderPlan plan = RenderPlan.of(studio);
        Star gammaDraconis = StarCatalogue.upTo(3).stream()
                .filter(star -> star.rightAscensionDegrees() == 269.1515 && star.declinationDegrees() == 51.4889)
                .findFirst()
                .orElseThrow();
        assertThat(plan.middleHistory().lastDirection().distance(sky(studio).direction(gammaDraconis)))
                .isLessThan(1e-6);
        double pixel = 2 * Math.tan(Math.toRadians(24)) / 640;
        for (double across : new double[] {-150, -40, 90, 200}) {
            Vector3d right = new Vector3d(ahead.z, 0, -ahead.x);
            double angle = Math.asin(index * Math.sin(Math.atan(across * pixel)));
            Vector3d seen = new Vector3d(right).mul(Math.sin(angle)).fma(Math.cos(angle), ahead);
            // aberration along x: x = (x' - beta)/(1 - beta x'), z = z'/(gamma (1 - beta x'))
            double gamma = 1 / Math.sqrt(1 - speed * speed);
            double scale = 1 - speed * seen.x;
            Vector3d star = new Vector3d((seen.x - speed) / scale, 0, seen.z / (gamma * scale));
            SampleHistory life = SampleHistory.of(plan, 320 + across, 240, 0, 0);
            assertThat(life.lastDirection().distance(star)).isLessThan(1e-12);
        }
    }

    private static Studio telescope(Vector3d ahead, double index) {
        Studio scene = SceneFiles.read("airy-telescope");
        Cylinder water = (Cylinder) scene.cameraFrame().get(0);
        assertThat(water.end().normalize(0.3, new Vector3d()).distance(new Vector3d(0.18, 0, 0.24)))
                .isLessThan(1e-15);
        Cylinder turned = new Cylinder(
                "water",
                ahead.mul(-0.1, new Vector3d()),
                ahead.mul(0.3, new Vector3d()),
                water.radius(),
                true,
                new Refractive(index));
        return scene.withCameraFrame(List.of(turned))
                .withVelocity(Velocity.of(ahead.x, 0, 0))
                .withCamera(Descriptions.with(scene.camera(), "viewDirection", ahead));
    }

    /** The photograph itself: the brightest spot between the cross hairs, and Vega, which the water draws to it. */
    @Test
    void theTelescopeShowsItsStars() throws Exception {
        Studio scene = SceneFiles.read("airy-telescope");
        LinearImage wet = SceneFiles.render(scene.withSettings(scene.settings().withSamples(1)));
        Studio emptied = scene.withCameraFrame(
                scene.cameraFrame().subList(1, scene.cameraFrame().size()));
        LinearImage dry =
                SceneFiles.render(emptied.withSettings(scene.settings().withSamples(1)));
        Vector3d vega = look(scene, NAMED.get("Vega"));
        double sine = vega.cross(new Vector3d(0.6, 0, 0.8), new Vector3d()).length();
        double perRadian = 320 / Math.tan(Math.toRadians(24));
        for (LinearImage image : List.of(wet, dry)) {
            assertThat(middleOfLight(image, 320, 240, 4).distance(320, 240)).isLessThan(0.1);
        }
        assertThat(middleOfLight(wet, 264, 340, 6).distance(320, 240))
                .isCloseTo(perRadian * Math.tan(Math.asin(sine * 0.75)), within(0.2));
        assertThat(middleOfLight(dry, 245, 375, 6).distance(320, 240))
                .isCloseTo(perRadian * Math.tan(Math.asin(sine)), within(0.2));
    }

    /** The middle of the light of a square of a picture, in pixels, as far as it is brighter than the sky. */
    private static Vector2d middleOfLight(LinearImage image, int column, int row, int half) {
        double sum = 0;
        Vector2d middle = new Vector2d();
        for (int y = row - half; y < row + half; y++) {
            for (int x = column - half; x < column + half; x++) {
                double light = Math.max(0, image.value(x, y, 1) - 0.03);
                sum += light;
                middle.add(light * (x + 0.5), light * (y + 0.5));
            }
        }
        return middle.div(sum);
    }

    @Test
    void explainSaysWhatWaterDoes() {
        assertThat(new Explanation(RenderPlan.of(SceneFiles.read("airy-telescope"))).sentences())
                .contains(
                        "The lens rests in a medium of index 1.333: behind a flat face across the view, what is in the middle"
                                + " of the picture stays there at any speed, as without the medium, and sines of angles to the"
                                + " middle are divided by the index.");
        assertThat(new Explanation(RenderPlan.of(SceneFiles.read("telescope"))).sentences())
                .noneMatch(sentence -> sentence.contains("medium"));
    }

    /** tan(i/2) = (1 + v)/(1 - v) tan(r/2), and the frequency grows by sin(i)/sin(r): 3 on the axis for v = 1/2. */
    @Test
    void theMirrorThatComesDrawsStarsTogether() {
        Studio scene = SceneFiles.read("stars-mirror");
        RenderPlan plan = RenderPlan.of(scene);
        double perRadian = 320 / Math.tan(Math.toRadians(30));
        for (double degrees : new double[] {2, 8, 15}) {
            double r = Math.toRadians(degrees);
            double i = 2 * Math.atan(3 * Math.tan(r / 2));
            SampleHistory life = SampleHistory.of(plan, 320 + perRadian * Math.tan(r), 240, 0, 0);
            assertThat(life.lastDirection().distance(new Vector3d(Math.sin(i), 0, -Math.cos(i))))
                    .isLessThan(1e-12);
            assertThat(life.lastDopplerFactor()).isCloseTo(Math.sin(i) / Math.sin(r), within(1e-12));
        }
        SampleHistory middle = plan.middleHistory();
        assertThat(middle.lastDopplerFactor()).isCloseTo(3, within(1e-12));
        assertThat(middle.end() == null ? middle.hits().get(0).event().z() : Double.NaN)
                .isCloseTo(6, within(1e-12));
        assertThat(middle.hits().get(0).event().time()).isCloseTo(-6, within(1e-12));
    }

    /** Betelgeuse behind the camera is seen where the mirror's formula says, as blue as Rigel is at rest. */
    @Test
    void betelgeuseInTheMirrorIsAsBlueAsRigel() throws Exception {
        Studio scene = SceneFiles.read("stars-mirror");
        Vector3d star = sky(scene).direction(NAMED.get("Betelgeuse"));
        double i = Math.acos(-star.z);
        double r = 2 * Math.atan(Math.tan(i / 2) / 3);
        double distance = 320 / Math.tan(Math.toRadians(30)) * Math.tan(r);
        Vector2d place = new Vector2d(star.x, -star.y).normalize(distance).add(320, 240);

        LinearImage image =
                SceneFiles.render(scene.withSettings(scene.settings().withSamples(1)));

        assertThat(middleOfLight(image, (int) Math.round(place.x), (int) Math.round(place.y), 3)
                        .distance(place))
                .isLessThan(0.3);
        double temperature = NAMED.get("Betelgeuse").temperature() * Math.sin(i) / Math.sin(r);
        assertThat(temperature).isCloseTo(NAMED.get("Rigel").temperature(), within(1000.0));
    }
}
