package tompkins.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.camera.ThinLensCamera;
import tompkins.ray.Colour;
import tompkins.render.RenderReport;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.surface.LuminousSurface;
import tompkins.surface.Mirror;
import tompkins.surface.Surface;
import tompkins.surface.Tiling;

/** Corridors of two mirrors: the light that is left is known, however often the ray goes to and fro. */
class MirrorCorridorTest {

    private static final Surface LAMP = new LuminousSurface(Colour.WHITE, false);

    /** One pixel that looks along x with a slope, between mirrors at x = -1 and x = 1, with a lamp at z = bounces. */
    private static Photograph corridor(Surface walls, int bounces, int depth) {
        List<SceneObject> scene = List.of(
                new Plane("left", new Vector3d(-1, 0, 0), new Vector3d(1, 0, 0), walls),
                new Plane("right", new Vector3d(1, 0, 0), new Vector3d(1, 0, 0), walls),
                new Plane("lamp", new Vector3d(0, 0, 2 * bounces), new Vector3d(0, 0, 1), LAMP));
        ThinLensCamera camera = Photograph.pinhole(new Vector3d(1, 0, 1), 1, 0);
        RenderSettings settings = new RenderSettings(
                1, 1, 1, 0, 1, depth, Studio.DEFAULT.settings().toneCurve());
        return new Photograph(Studios.dark().withScene(scene).withCamera(camera).withSettings(settings));
    }

    private static double light(Photograph photograph) {
        return photograph.image().value(0, 0, 0);
    }

    /** The ray meets a wall after 1, 3, 5, ... units of z: as often as there are odd numbers below 2 n. */
    @ParameterizedTest
    @CsvSource({"0.5, 9", "0.9, 60", "0.96, 150", "0.99, 600", "1, 900"})
    void lightFallsByThePowerOfTheReflectance(double reflectance, int bounces) {
        Photograph photograph = corridor(new Mirror(reflectance), bounces, 1000);
        assertThat(light(photograph)).isCloseTo(Math.pow(reflectance, bounces), within(1e-6));
        assertThat(photograph.job().report().counts().tooFaint).isZero();
        assertThat(photograph.job().report().warnings()).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({"0.9, 66", "0.96, 170", "0.99, 690"})
    void faintLightIsGivenUpAndCounted(double reflectance, int bounces) {
        Photograph photograph = corridor(new Mirror(reflectance), bounces, 1000);
        assertThat(light(photograph)).isZero();
        assertThat(Math.pow(reflectance, bounces)).as("what is missing").isLessThan(1.0 / 1024);
        assertThat(photograph.job().report().counts().tooFaint).isEqualTo(1);
    }

    /** Tiles of which each pixel sees many, of tiles, of tiles, ...: with each level there are twice as many rays. */
    private static Surface mirrorInTilings(int levels) {
        if (levels == 0) {
            return new Mirror(0.9);
        }
        Surface tiles = mirrorInTilings(levels - 1);
        return new Tiling(tiles, tiles, 1e-9, 1e-9, true);
    }

    /** With ten levels each ray has 0.9/1024 of the light and is given up, and all of it is missing. */
    @Test
    void lightThatIsLostByManyFaintRaysIsTold() {
        Photograph nine = corridor(mirrorInTilings(9), 1, 1000);
        assertThat(light(nine)).isCloseTo(0.9, within(1e-6));
        assertThat(nine.job().report().warnings()).isEmpty();

        Photograph ten = corridor(mirrorInTilings(10), 1, 1000);
        assertThat(light(ten)).isZero();
        assertThat(ten.job().report().counts().lostLight()).isCloseTo(0.9, within(1e-6));
        assertThat(ten.job().report().warnings())
                .containsExactly("1024 rays were too faint to be followed; together they could have brought 90 % of the"
                        + " light");
    }

    @Test
    void perfectMirrorsEndAtTheDepthWithAWarning() {
        Photograph photograph = corridor(new Mirror(1), 1200, 1000);
        RenderReport report = photograph.job().report();
        assertThat(light(photograph)).isZero();
        assertThat(report.counts().tooDeep).isEqualTo(1);
        assertThat(report.warnings()).singleElement().asString().contains("maximumDepth");
    }

    /** A recursion would need some hundred bytes of stack for each bounce. */
    @Test
    void halfAMillionBouncesNeedNoStack() {
        Photograph photograph = corridor(new Mirror(1), 500_000, 1_000_000);
        assertThat(light(photograph)).isEqualTo(1);
        assertThat(photograph.job().report().counts().rays).isEqualTo(500_001);
    }

    /** Walls whose tiles, far smaller than a pixel, are half lamp and half mirror: a geometric sum. */
    @ParameterizedTest
    @ValueSource(doubles = {0.5, 0.9, 0.99, 1})
    void tilesOfLampsAndMirrorsGiveTheGeometricSum(double reflectance) {
        Tiling tiles = new Tiling(LAMP, new Mirror(reflectance), 1e-9, 1e-9, true);
        Photograph photograph = corridor(tiles, 900, 1000);
        double sum = 0.5 / (1 - 0.5 * reflectance);
        assertThat(light(photograph)).isCloseTo(sum, within(2.0 / 1024));
    }

    /** Two branches at every bounce: the work must not double each time. */
    @Test
    void tilesOfTwoMirrorsLoseNothingAndEndSoon() {
        Tiling tiles = new Tiling(new Mirror(1), new Mirror(1), 1e-9, 1e-9, true);
        Photograph photograph = corridor(tiles, 100, 1000);
        assertThat(light(photograph)).isCloseTo(1, within(1e-6));
        assertThat(photograph.job().report().counts().rays).isLessThan(200_000);
    }
}
