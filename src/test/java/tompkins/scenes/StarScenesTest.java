package tompkins.scenes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.light.Star;
import tompkins.light.StarCatalogue;
import tompkins.studio.RideLeg;
import tompkins.studio.RideMoment;
import tompkins.studio.StarSky;
import tompkins.studio.Studio;
import tompkins.world.SeenFrame;

/** What the scenes of the topic Stars, and the ride among them, tell in their remarks. */
class StarScenesTest {

    private static final Map<String, Star> NAMED =
            StarCatalogue.names().entrySet().stream().collect(Collectors.toMap(Map.Entry::getValue, Map.Entry::getKey));

    private static StarSky sky(Studio studio) {
        return (StarSky) studio.background();
    }

    private static Vector3d look(Studio studio, Star star) {
        return new SeenFrame(studio, null).look(sky(studio).direction(star));
    }

    private static double dopplerFactor(Studio studio, Star star) {
        return new SeenFrame(studio, null).dopplerFactorAlong(sky(studio).direction(star));
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
}
