package tompkins.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.camera.Camera;
import tompkins.camera.PanoramicCamera;
import tompkins.image.LinearImage;
import tompkins.light.ColourLaw;
import tompkins.light.Metering;
import tompkins.light.StarCatalogue;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.render.RenderJob;
import tompkins.render.RenderListener;
import tompkins.render.Renderer;
import tompkins.sceneobject.Box;
import tompkins.sceneobject.Disc;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Parallelogram;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.RenderSettings;
import tompkins.studio.StarSky;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.studio.View;
import tompkins.surface.ComplexRefraction;
import tompkins.surface.ConfocalLensletArray;
import tompkins.surface.IdealLens;
import tompkins.surface.LorentzWindow;
import tompkins.surface.Mirror;
import tompkins.surface.Surface;
import tompkins.surface.WindowAxes;
import tompkins.trace.RenderPlan;

/**
 * How much light of a star a picture gets, and where, against closed formulas: the flux is that of the catalogue times
 * D^2 or 1, the place that of aberration, tan(a'/2) = tan(a/2) sqrt((1 - beta)/(1 + beta)).
 */
class StarLightTest {

    /** Sirius alone is brighter. */
    private static final double ALONE = -1;

    private static final double SQUARE_DEGREES = 0.2;

    /** The solid angle of white that gives as much light as Sirius, of magnitude -1.44. */
    static final double LIGHT = Math.pow(10, 0.4 * 1.44) * SQUARE_DEGREES * Math.pow(Math.PI / 180, 2);

    /** A sky in which Sirius stands in a direction; the sky is turned, and the camera stays. */
    static StarSky sky(Vector3d star) {
        // the pole on the great circle through the star, at the distance of its declination
        double declination = Math.toRadians(-16.7161);
        double rightAscension = Math.toRadians(101.2872);
        Vector3d aside = new Vector3d(0.3, 0.9, 0.2).cross(star).normalize();
        Vector3d up = new Vector3d(star).cross(aside).normalize();
        Vector3d north = new Vector3d(star).mul(Math.sin(declination)).fma(Math.cos(declination), up);
        // the projection of the star on the equator is at its right ascension
        Vector3d meridian =
                new Vector3d(star).fma(-Math.sin(declination), north).normalize();
        Vector3d east = new Vector3d(meridian).cross(north).negate();
        Vector3d zero = new Vector3d(meridian).mul(Math.cos(rightAscension)).fma(Math.sin(rightAscension), east);
        StarSky sky = new StarSky(ALONE, SQUARE_DEGREES, north, zero, Colour.BLACK);
        Vector3d found = sky.direction(StarCatalogue.upTo(ALONE).get(0));
        assertThat(found.distance(star)).isLessThan(1e-14);
        return sky;
    }

    /** The direction in the scene that is seen along another by a camera with a speed along z. */
    static Vector3d inScene(Vector3d look, double beta) {
        double angle = Math.acos(look.z / look.length());
        double scene = 2 * Math.atan(Math.tan(angle / 2) * Math.sqrt((1 + beta) / (1 - beta)));
        double level = Math.hypot(look.x, look.y);
        return new Vector3d(Math.sin(scene) * look.x / level, Math.sin(scene) * look.y / level, Math.cos(scene));
    }

    static double dopplerFactor(Vector3d look, double beta) {
        return 1 / (1 - beta * look.z / look.length()) * Math.sqrt(1 - beta * beta);
    }

    /** Luminance of the picture, summed with the solid angles of pixels, and its middle in pixels. */
    record Spot(double flux, Vector2d middle, double brightest) {

        static Spot of(Studio studio) {
            Photograph photograph = new Photograph(studio);
            return of(photograph, photograph.image());
        }

        static Spot of(Photograph photograph, LinearImage image) {
            return of(photograph, image, image.width() / 2.0, image.height() / 2.0, image.width());
        }

        /** What the picture shows within a radius of a place, all in pixels. */
        static Spot of(Photograph photograph, LinearImage image, double x, double y, double radius) {
            double flux = 0;
            double sum = 0;
            double brightest = 0;
            Vector2d middle = new Vector2d();
            for (int row = 0; row < image.height(); row++) {
                for (int column = 0; column < image.width(); column++) {
                    if (Math.hypot(column + 0.5 - x, row + 0.5 - y) > radius) {
                        continue;
                    }
                    double luminance = Colour.luminance(
                            image.value(column, row, 0), image.value(column, row, 1), image.value(column, row, 2));
                    flux += luminance * solidAngle(photograph, column, row);
                    sum += luminance;
                    brightest = Math.max(brightest, luminance);
                    middle.add((column + 0.5) * luminance, (row + 0.5) * luminance);
                }
            }
            return new Spot(flux, middle.div(sum), brightest);
        }

        /** That of a pyramid over two triangles (A. van Oosterom, J. Strackee 1983). */
        private static double solidAngle(Photograph photograph, int column, int row) {
            Vector3d a = new Vector3d(photograph.plan().chiefDirection(column, row));
            Vector3d b = new Vector3d(photograph.plan().chiefDirection(column + 1, row));
            Vector3d c = new Vector3d(photograph.plan().chiefDirection(column + 1, row + 1));
            Vector3d d = new Vector3d(photograph.plan().chiefDirection(column, row + 1));
            return solidAngle(a, b, c) + solidAngle(a, c, d);
        }

        private static double solidAngle(Vector3d a, Vector3d b, Vector3d c) {
            double volume = Math.abs(a.dot(b.cross(c, new Vector3d())));
            return 2 * Math.atan2(volume, 1 + a.dot(b) + b.dot(c) + c.dot(a));
        }
    }

    static Studio studio(Vector3d look, double beta, int width, int samples, double angle) {
        StarSky sky = sky(inScene(look, beta));
        Studio dark = Descriptions.with(Studios.dark(), "background", sky);
        return Descriptions.with(dark, "metering", Metering.NONE)
                .withCamera(Photograph.pinhole(new Vector3d(0, 0, 1), angle, 0))
                .withVelocity(Velocity.of(0, 0, beta))
                .withSettings(
                        Studio.DEFAULT.settings().withSize(width, width * 3 / 4).withSamples(samples));
    }

    /** The look direction of a point of a picture. */
    static Vector3d look(double x, double y, int width, double angle) {
        double slope = 2 * Math.tan(Math.toRadians(angle) / 2) / width;
        return new Vector3d((x - width / 2.0) * slope, (width * 3 / 4 / 2.0 - y) * slope, 1);
    }

    private static void expect(Studio studio, double flux, double x, double y) {
        Spot spot = Spot.of(studio);
        assertThat(spot.flux() / flux).isCloseTo(1, within(0.01));
        assertThat(spot.middle().distance(x, y)).isLessThan(0.1);
    }

    static Stream<Arguments> pictures() {
        List<Arguments> pictures = new ArrayList<>();
        for (int width : new int[] {16, 64, 320}) {
            for (int samples : new int[] {1, 3, 16}) {
                pictures.add(Arguments.of(width, samples));
            }
        }
        return pictures.stream();
    }

    @ParameterizedTest
    @MethodSource("pictures")
    void aStarHasItsLightAndPlaceInEveryPicture(int width, int samples) {
        int[] places = width > 100 ? new int[] {7} : new int[] {0, 6, 12, 18, 24};
        for (int place : places) {
            double x = width * 0.3 + place % 5 * 0.2;
            double y = width * 0.25 + place / 5 * 0.2;
            for (double beta : new double[] {0, 0.9}) {
                Studio studio = studio(look(x, y, width, 90), beta, width, samples, 90);
                expect(studio, LIGHT, x, y);
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"0.5, 1", "0.5, 4", "0.9, 1", "0.9, 4", "0.99, 1", "-0.9, 1"})
    void theSearchlightMakesAStarBrighterByTheSquareOfD(double beta, int samples) {
        double x = 40.3;
        double y = 11.8;
        Vector3d look = look(x, y, 64, 60);
        double factor = dopplerFactor(look, beta);
        Studio studio = studio(look, beta, 64, samples, 60).withColours(ColourLaw.SEARCHLIGHT);
        expect(studio, LIGHT * factor * factor, x, y);
    }

    /** A picture that seeks an error takes other numbers of samples in each pixel. */
    @ParameterizedTest
    @CsvSource({"0", "0.9"})
    void samplesWhereTheyAreNeededKeepTheLight(double beta) {
        Studio studio = studio(look(40.3, 11.8, 64, 60), beta, 64, 1, 60);
        RenderSettings settings = Descriptions.with(studio.settings(), "targetError", 0.001);
        expect(studio.withSettings(settings), LIGHT, 40.3, 11.8);
    }

    /** In the picture all around, at its seam and its poles, too. */
    @ParameterizedTest
    @CsvSource({"0.4, 20.2", "90.1, 30.6", "179.9, 70.1", "33.3, 0.3", "33.3, 89.8", "100, 2.1"})
    void aPanoramaShowsAllLightOfAStar(double x, double y) {
        Camera camera = PanoramicCamera.DEFAULT;
        double longitude = Math.toRadians((x - 90) * 2);
        double latitude = Math.toRadians((45 - y) * 2);
        Vector3d look = new Vector3d(
                Math.cos(latitude) * Math.sin(longitude), Math.sin(latitude), Math.cos(latitude) * Math.cos(longitude));
        Studio studio = studio(look, 0.5, 64, 1, 90).withCamera(camera);
        Spot spot = Spot.of(studio.withSettings(studio.settings().withSize(180, 90)));
        assertThat(spot.flux() / LIGHT).isCloseTo(1, within(0.01));
    }

    /** What covers the left half of the picture takes the light that falls there. */
    @ParameterizedTest
    @CsvSource({"1", "4", "16"})
    void whatStandsBeforeAStarHidesIt(int samples) {
        Studio studio = studio(look(40.3, 11.8, 64, 60), 0.5, 64, samples, 60);
        assertThat(green(studio.withCameraFrame(List.of(wall(-50, 0)))) / green(studio))
                .isCloseTo(1, within(1e-6));
        assertThat(green(studio.withCameraFrame(List.of(wall(0, 50))))).isEqualTo(0);
    }

    private static SceneObject wall(double left, double right) {
        return new Box("wall", new Vector3d(left, -50, 5), new Vector3d(right, 50, 6), Photograph.RED);
    }

    private static double green(Studio studio) {
        LinearImage image = new Photograph(studio).image();
        double sum = 0;
        for (int i = 1; i < image.rgb().length; i += 3) {
            sum += image.rgb()[i];
        }
        return sum;
    }

    /** A sheet that fills the picture, with the normal (1, 0, -1)/sqrt 2 if it stands aslant. */
    private static SceneObject sheet(Surface surface, boolean aslant) {
        Vector3d across = aslant ? new Vector3d(40, 0, 40) : new Vector3d(40, 0, 0);
        Vector3d corner = new Vector3d(0, -20, aslant ? 20 : 5).fma(-0.5, across);
        return new Parallelogram("sheet", corner, across, new Vector3d(0, 40, 0), surface);
    }

    /** A direction in a mirror aslant. */
    private static Vector3d mirrored(Vector3d look) {
        return new Vector3d(look.z, look.y, look.x);
    }

    /** Where a mirror is, the star that is seen in it, and its Doppler factor. */
    enum MirrorPlace {
        WITH_CAMERA,
        IN_SCENE,
        MOVING;

        Studio with(Studio studio, SceneObject mirror) {
            return switch (this) {
                case WITH_CAMERA -> studio.withCameraFrame(List.of(mirror));
                case IN_SCENE -> studio.withScene(List.of(mirror));
                case MOVING ->
                    studio.withScene(
                            List.of(new Moving("moving", studio.velocity(), new Vector3d(), 0, List.of(mirror))));
            };
        }

        Vector3d star(Vector3d look, double beta) {
            return this == IN_SCENE ? mirrored(inScene(look, beta)) : inScene(mirrored(look), beta);
        }

        double dopplerFactor(Vector3d look, double beta) {
            return StarLightTest.dopplerFactor(this == IN_SCENE ? look : mirrored(look), beta);
        }
    }

    static Stream<Arguments> mirrors() {
        return Stream.of(MirrorPlace.values())
                .flatMap(place -> Stream.of(1, 5)
                        .flatMap(samples -> Stream.of(ColourLaw.UNCHANGED, ColourLaw.SEARCHLIGHT)
                                .map(law -> Arguments.of(place, samples, law))));
    }

    @ParameterizedTest
    @MethodSource("mirrors")
    void aStarInAMirrorKeepsItsLight(MirrorPlace place, int samples, ColourLaw law) {
        double beta = 0.6;
        Vector3d look = look(40.3, 11.8, 64, 60);
        Studio straight = studio(look, beta, 64, samples, 60).withColours(law);
        Studio studio = place.with(
                Descriptions.with(straight, "background", sky(place.star(look, beta))), sheet(new Mirror(1), true));
        double factor = law == ColourLaw.UNCHANGED ? 1 : place.dopplerFactor(look, beta);
        expect(studio, LIGHT * factor * factor, 40.3, 11.8);
    }

    /** A window with the velocity of the camera undoes the aberration; the star stays as bright as the law says. */
    @ParameterizedTest
    @CsvSource({"1, UNCHANGED", "3, UNCHANGED", "16, UNCHANGED", "1, SEARCHLIGHT"})
    void aStarBehindAWindowKeepsItsLight(int samples, ColourLaw law) {
        double beta = 0.9;
        Vector3d look = look(40.3, 11.8, 64, 60).normalize();
        LorentzWindow window = new LorentzWindow(Velocity.of(0, 0, beta), WindowAxes.FRAME, 1);
        Studio studio = Descriptions.with(studio(look, beta, 64, samples, 60).withColours(law), "background", sky(look))
                .withCameraFrame(List.of(sheet(window, false)));
        // the frequency is that of the direction in which the light crosses into the scene
        Vector3d inFront = inScene(look, -beta);
        double factor = law == ColourLaw.UNCHANGED ? 1 : dopplerFactor(inFront, beta);
        expect(studio, LIGHT * factor * factor, 40.3, 11.8);
    }

    /**
     * Sheets that bend light show a star with the ratio of solid angles, as mirrors and glass do. Slopes s to their
     * normal are turned to s' = a s + b; a solid angle is that of the slopes times the third power of the cosine.
     */
    @ParameterizedTest
    @CsvSource({
        "LENS, 0, 1",
        "LENS, 0, 4",
        "LENS, 0.6, 1",
        "LENSLETS, 0, 1",
        "LENSLETS, 0, 3",
        "LENSLETS, 0.6, 1",
        "REFRACTION, 0, 1",
        "REFRACTION, 0, 3",
        "REFRACTION, 0.6, 1"
    })
    void aSheetShowsTheRatioOfSolidAngles(Sheet sheet, double beta, int samples) {
        double x = 46.3;
        double y = 13.8;
        Vector3d look = look(x, y, 64, 60);
        Disc disc = new Disc("sheet", new Vector3d(0, 0, 1), new Vector3d(0, 0, -1), 3, sheet.surface);
        Vector3d star = sheet.beyond(look);
        double step = 1e-5;
        Vector3d right = sheet.beyond(new Vector3d(look).add(step, 0, 0)).sub(star);
        Vector3d up = sheet.beyond(new Vector3d(look).add(0, step, 0)).sub(star);
        double cosine = 1 / look.length();
        double light = cosine * cosine * cosine * step * step / right.cross(up).length();
        Studio studio = Descriptions.with(studio(look, beta, 64, samples, 60), "background", sky(inScene(star, beta)));
        expect(studio.withCameraFrame(List.of(disc)), LIGHT * light, x, y);
    }

    /** What sheets at the distance 1 make of directions, whose depth is 1. */
    enum Sheet {
        LENS(new IdealLens(3, 0.5, 0.5, 1), look -> new Vector3d(look.x * 2 / 3, look.y * 2 / 3, 1)),
        /** The ray enters at the front. */
        LENSLETS(new ConfocalLensletArray(1.4, 0.8, 0, 0, 1), look -> new Vector3d(look.x * 1.4, look.y * 0.8, 1)),
        REFRACTION(new ComplexRefraction(1.3, 0, 1), look -> {
            double sine = Math.hypot(look.x, look.y) / look.length() / 1.3;
            double slope = sine / Math.sqrt(1 - sine * sine) / Math.hypot(look.x, look.y);
            return new Vector3d(look.x * slope, look.y * slope, 1);
        });

        private final Surface surface;
        private final UnaryOperator<Vector3d> slopes;

        Sheet(Surface surface, UnaryOperator<Vector3d> slopes) {
            this.surface = surface;
            this.slopes = slopes;
        }

        Vector3d beyond(Vector3d look) {
            return slopes.apply(look).normalize();
        }
    }

    /**
     * A camera with a wide aperture of radius r gets no more light of a star; focused at the distance f it shows it as
     * a disc whose slopes go to r/f, with half the square of that as the mean square. Samples take points of the lens.
     */
    @ParameterizedTest
    @CsvSource({"0, 16, 1000", "0.9, 16, 1000", "0, 64, 2", "0.9, 64, 0.7", "0, 64, -1"})
    void aWideApertureKeepsTheLight(double beta, int samples, double focus) {
        double radius = 0.05;
        Studio studio = studio(look(30.3, 23.8, 64, 60), beta, 64, samples, 60);
        Camera open = Descriptions.with(
                Descriptions.with(studio.camera(), "apertureRadius", radius),
                "focus",
                new Plane("focus", new Vector3d(0, 0, focus), new Vector3d(0, 0, -1), Photograph.RED));
        expect(studio.withCamera(open), LIGHT, 30.3, 23.8);
        double blur = radius / focus / (2 * Math.tan(Math.toRadians(30)) / 64);
        LinearImage image = new Photograph(studio.withCamera(open)).image();
        double sum = 0;
        double squares = 0;
        for (int row = 0; row < image.height(); row++) {
            for (int column = 0; column < image.width(); column++) {
                double light = image.value(column, row, 1);
                double away = Math.hypot(column + 0.5 - 30.3, row + 0.5 - 23.8);
                sum += light;
                squares += light * away * away;
            }
        }
        // the spot of a point has the standard deviation 0.7 each way, and ends at four times that
        assertThat(squares / sum).isCloseTo(2 * 0.7 * 0.7 + blur * blur / 2, within(0.02 + 0.02 * blur * blur));
    }

    /** What covers half of the picture, and is in focus itself, hides half of the disc of a star. */
    @Test
    void whatIsInFocusCutsTheDiscOfAStar() {
        Studio studio = studio(look(32.001, 24.001, 64, 60), 0, 64, 64, 60);
        Camera open = Descriptions.with(
                Descriptions.with(studio.camera(), "apertureRadius", 0.5),
                "focus",
                new Plane("focus", new Vector3d(0, 0, 5), new Vector3d(0, 0, -1), Photograph.RED));
        Studio wide = studio.withCamera(open);
        Parallelogram left = new Parallelogram(
                "left", new Vector3d(-50, -50, 5), new Vector3d(50, 0, 0), new Vector3d(0, 100, 0), Photograph.RED);
        assertThat(green(wide.withScene(List.of(left))) / green(wide)).isCloseTo(0.5, within(0.01));
    }

    /** While the speed is dragged a star moves by parts of pixels; a glimpse must show all of it in each picture. */
    @Test
    void starsDoNotTwinkleWhileTheSpeedIsDragged() throws InterruptedException {
        Vector3d look = look(90.3, 31.8, 128, 60);
        double least = Double.POSITIVE_INFINITY;
        double most = 0;
        try (Renderer renderer = new Renderer(2)) {
            for (double beta = 0.5; beta < 0.53; beta += 0.001) {
                Studio studio = studio(look, 0.5, 128, 1, 60).withVelocity(Velocity.of(0, 0, beta));
                RenderJob job = renderer.startGlimpse(RenderPlan.of(studio), 0.001, new RenderListener() {});
                job.await();
                Spot spot = Spot.of(new Photograph(studio), job.image());
                assertThat(spot.flux() / LIGHT).isCloseTo(1, within(0.01));
                least = Math.min(least, spot.brightest());
                most = Math.max(most, spot.brightest());
            }
        }
        // from the middle of a pixel to its corner: exp(0.5/(2 0.7^2))
        assertThat(most / least).isBetween(1.2, 1.67);
    }

    /**
     * In a Galilean world d is seen along d' = d + beta; measured, lengths along the motion are gamma times as long.
     */
    @ParameterizedTest
    @CsvSource({
        "GALILEAN, SEEN, 1",
        "GALILEAN, SEEN, 4",
        "LORENTZ, MEASURED, 1",
        "LORENTZ, MEASURED, 4",
        "NONE, SEEN, 1"
    })
    void starsStandWhereEachLawPutsThem(TransformationLaw law, View view, int samples) {
        double beta = 0.6;
        Vector3d look = look(40.3, 11.8, 64, 60).normalize();
        Vector3d star = new Vector3d(look);
        if (law == TransformationLaw.GALILEAN) {
            star.z -= beta;
        } else if (view == View.MEASURED) {
            star.z *= 1.25;
        }
        Studio studio = Descriptions.with(studio(look, beta, 64, samples, 60), "background", sky(star.normalize()))
                .withTransformation(law)
                .withView(view)
                .withColours(ColourLaw.SEARCHLIGHT);
        expect(studio, LIGHT, 40.3, 11.8);
    }
}
