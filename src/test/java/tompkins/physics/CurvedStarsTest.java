package tompkins.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.function.DoubleUnaryOperator;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.TestRun;
import tompkins.light.ColourLaw;
import tompkins.property.Descriptions;
import tompkins.sceneobject.Lens;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.surface.Mirror;
import tompkins.surface.Refractive;
import tompkins.surface.Surface;

/**
 * Stars in curved mirrors and behind curved glass, in single pictures. What is round about the axis of view turns light
 * that is seen at the angle a from it to another angle t(a), and shows a star with the light of sin a da / (sin t dt):
 * radiance stays the same, and a solid angle is one of rings.
 */
class CurvedStarsTest {

    private static final int WIDTH = 64;

    /**
     * So far the spot of a star reaches in pixels: glass shows fainter ones beside it, which it has mirrored inside.
     */
    private static final double SPOT = 2.9;

    private static final Surface MIRROR = new Mirror(1);

    /** What a camera sees that moves along the axis: angles are smaller by aberration. */
    private static double aberrated(double angle, double beta) {
        return 2 * Math.atan(Math.tan(angle / 2) * Math.sqrt((1 + beta) / (1 - beta)));
    }

    private static double magnification(DoubleUnaryOperator turned, double angle) {
        double step = 1e-5;
        double slope = (turned.applyAsDouble(angle + step) - turned.applyAsDouble(angle - step)) / (2 * step);
        return Math.abs(Math.sin(angle) / (Math.sin(turned.applyAsDouble(angle)) * slope));
    }

    /** A star whose light is seen at a place of the picture, after it was turned. */
    private static Vector3d star(Vector3d look, double angle) {
        double level = Math.hypot(look.x, look.y);
        return new Vector3d(Math.sin(angle) * look.x / level, Math.sin(angle) * look.y / level, Math.cos(angle));
    }

    private static double angle(Vector3d look) {
        return Math.atan2(Math.hypot(look.x, look.y), look.z);
    }

    /** Twenty-five places in a pixel; the first has its corner there. */
    private static void forEachPlace(double pixelX, double pixelY, Place place) {
        for (int i = 0; i < 25; i += TestRun.cases(12, 1)) {
            place.at(pixelX + i % 5 * 0.2 + 0.05, pixelY + i / 5 * 0.2 + 0.05);
        }
    }

    private interface Place {
        void at(double x, double y);
    }

    private static Studio studio(Vector3d star, double beta, int samples, double degrees, SceneObject object) {
        return Descriptions.with(
                        StarLightTest.studio(new Vector3d(0.1, 0, 1), beta, WIDTH, samples, degrees),
                        "background",
                        StarLightTest.sky(star))
                .withScene(List.of(object));
    }

    private static void expect(Studio studio, double light, double x, double y, double radius) {
        Photograph photograph = new Photograph(studio);
        StarLightTest.Spot spot = StarLightTest.Spot.of(photograph, photograph.image(), x, y, radius);
        assertThat(spot.flux() / (StarLightTest.LIGHT * light)).isCloseTo(1, within(0.01));
        assertThat(spot.middle().distance(x, y)).isLessThan(0.1);
    }

    /** The angle in a convex mirror at the distance d, in units of its radius: the ray meets it at asin(d sin a). */
    private static double inBall(double angle, double distance) {
        return Math.PI + angle - 2 * Math.asin(distance * Math.sin(angle));
    }

    /** A ball in the picture, with its radius in pixels, and a star at a part of that from its middle. */
    @ParameterizedTest
    @CsvSource({
        "6, 0.1, 2, 1",
        "10, 0.1, 2, 1",
        "10, 0.6, 2, 1",
        "10, 0.6, 2, 5",
        "20, 0.05, 10, 1",
        "20, 0.3, 10, 1",
        "20, 0.6, 10, 1",
        "20, 0.85, 10, 1",
        "20, 0.85, 2, 5",
        "100, 0.1, 2, 1",
        "100, 0.25, 10, 1"
    })
    void aConvexMirrorShowsStarsSmall(double pixels, double part, double distance, int samples) {
        double degrees = degrees(pixels, distance);
        Sphere ball = new Sphere("ball", new Vector3d(0, 0, distance), 1, MIRROR);
        forEachPlace(Math.floor(32 + pixels * part * 0.8), Math.floor(24 - pixels * part * 0.6), (x, y) -> {
            Vector3d look = StarLightTest.look(x, y, WIDTH, degrees);
            double turned = inBall(angle(look), distance);
            expect(
                    studio(star(look, turned), 0, samples, degrees, ball),
                    magnification(a -> inBall(a, distance), angle(look)),
                    x,
                    y,
                    WIDTH);
        });
    }

    /** The field of view in which a ball has so many pixels as its radius. */
    private static double degrees(double pixels, double distance) {
        double slope = 1 / Math.sqrt(distance * distance - 1) / pixels;
        return 2 * Math.toDegrees(Math.atan(slope * WIDTH / 2));
    }

    /** A camera that moves along the axis, and a mirror that moves there; both change angles by aberration, too. */
    @ParameterizedTest
    @CsvSource({"0.9, 0, 1", "0.9, 0, 3", "0, 0.6, 1", "0.5, -0.8, 1", "-0.2, 0.4, 3"})
    void aConvexMirrorMovesPastStars(double beta, double mirrorBeta, int samples) {
        double distance = 3;
        double relative = (beta - mirrorBeta) / (1 - beta * mirrorBeta);
        // the ball has about 15 pixels as its radius where it is seen
        double seen = aberrated(Math.asin(1 / distance), -relative);
        double degrees = 2 * Math.toDegrees(Math.atan(Math.tan(seen) / 15 * WIDTH / 2));
        Sphere ball = new Sphere("ball", new Vector3d(0, 0, distance), 1, MIRROR);
        SceneObject moving =
                new Moving("moving", Velocity.of(0, 0, mirrorBeta), new Vector3d(), 0, List.<SceneObject>of(ball));
        forEachPlace(38, 17, (x, y) -> {
            Vector3d look = StarLightTest.look(x, y, WIDTH, degrees);
            double met = aberrated(angle(look), relative);
            double turned = inBall(met, distance);
            Vector3d star = star(look, aberrated(turned, mirrorBeta));
            double light = magnification(a -> inBall(a, distance), met);
            Studio studio = studio(star, beta, samples, degrees, moving);
            expect(studio, light, x, y, WIDTH);
            // frequency: camera against ball in the direction of the ray, ball against scene in that after the mirror
            double factor = dopplerFactor(look, relative) * dopplerFactor(star(look, turned), mirrorBeta);
            expect(studio.withColours(ColourLaw.SEARCHLIGHT), light * factor * factor, x, y, WIDTH);
        });
    }

    private static double dopplerFactor(Vector3d look, double beta) {
        return StarLightTest.dopplerFactor(look, beta);
    }

    /**
     * A hollow mirror. Before it, at the distance e from the middle of its sphere of radius R, the ray meets it at
     * asin(e sin a/R); e is below 0 between the middle and the mirror.
     */
    @ParameterizedTest
    @CsvSource({"1, 1", "1, 3", "1.7, 1", "3, 1"})
    void aHollowMirrorShowsStarsLargeAndSmall(double distance, int samples) {
        double radius = 2;
        Lens mirror = new Lens(
                "mirror",
                new Vector3d(0, 0, distance + 0.05),
                new Vector3d(0, 0, -1),
                0.5,
                0.1,
                -1 / radius,
                0,
                MIRROR);
        double fromMiddle = distance - Math.sqrt(radius * radius - 0.5 * 0.5);
        double degrees = 2 * Math.toDegrees(Math.atan(0.7 / distance));
        DoubleUnaryOperator turn = a -> Math.PI + a + 2 * Math.asin(fromMiddle * Math.sin(a) / radius);
        forEachPlace(38, 17, (x, y) -> {
            Vector3d look = StarLightTest.look(x, y, WIDTH, degrees);
            double turned = turn.applyAsDouble(angle(look));
            expect(
                    studio(star(look, turned), 0, samples, degrees, mirror),
                    magnification(turn, angle(look)),
                    x,
                    y,
                    WIDTH);
        });
    }

    /** Through a ball of glass: bent twice by i - r, less what Fresnel's equations mirror at its two boundaries. */
    @ParameterizedTest
    @CsvSource({"10, 0.3, 3, 1", "20, 0.2, 3, 1", "20, 0.6, 3, 3", "20, 0.85, 10, 1", "20, 0.85, 3, 1", "60, 0.3, 5, 1"
    })
    void aBallOfGlassShowsStarsBehindIt(double pixels, double part, double distance, int samples) {
        double index = 1.5;
        double degrees = degrees(pixels, distance);
        Sphere ball = new Sphere("ball", new Vector3d(0, 0, distance), 1, new Refractive(index));
        DoubleUnaryOperator turn = a -> {
            double in = Math.asin(distance * Math.sin(a));
            return a - 2 * (in - Math.asin(Math.sin(in) / index));
        };
        forEachPlace(Math.floor(32 + pixels * part * 0.8), Math.floor(24 - pixels * part * 0.6), (x, y) -> {
            Vector3d look = StarLightTest.look(x, y, WIDTH, degrees);
            double turned = turn.applyAsDouble(angle(look));
            double in = Math.asin(distance * Math.sin(angle(look)));
            double passed = 1 - mirrored(in, Math.asin(Math.sin(in) / index));
            expect(
                    studio(star(look, turned), 0, samples, degrees, ball),
                    magnification(turn, angle(look)) * passed * passed,
                    x,
                    y,
                    SPOT);
        });
    }

    /** What a ball of glass mirrors at its front, which is less than a twentieth of the light. */
    @ParameterizedTest
    @CsvSource({"20, 0.3, 3, 1", "20, 0.5, 5, 3"})
    void aBallOfGlassMirrorsStars(double pixels, double part, double distance, int samples) {
        double degrees = degrees(pixels, distance);
        Sphere ball = new Sphere("ball", new Vector3d(0, 0, distance), 1, new Refractive(1.5));
        forEachPlace(Math.floor(32 + pixels * part * 0.8), Math.floor(24 - pixels * part * 0.6), (x, y) -> {
            Vector3d look = StarLightTest.look(x, y, WIDTH, degrees);
            double in = Math.asin(distance * Math.sin(angle(look)));
            double light =
                    magnification(a -> inBall(a, distance), angle(look)) * mirrored(in, Math.asin(Math.sin(in) / 1.5));
            Vector3d star = star(look, inBall(angle(look), distance));
            expect(studio(star, 0, samples, degrees, ball), light, x, y, SPOT);
        });
    }

    private static double mirrored(double in, double out) {
        double across = Math.sin(in - out) / Math.sin(in + out);
        double along = Math.tan(in - out) / Math.tan(in + out);
        return (across * across + along * along) / 2;
    }
}
