package tompkins.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.joml.Vector3d;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.camera.ThinLensCamera;
import tompkins.image.LinearImage;
import tompkins.image.PictureDifference;
import tompkins.light.AlwaysOn;
import tompkins.light.Flash;
import tompkins.light.PointLight;
import tompkins.light.Pulse;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.ray.PixelPicture;
import tompkins.sceneobject.Parallelogram;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.spacetime.Velocity;
import tompkins.studio.Lighting;
import tompkins.studio.PanoramaBackground;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.surface.ColouredSurface;
import tompkins.surface.LuminousSurface;
import tompkins.trace.RenderPlan;

/** Lights that are much smaller than a pixel are not lost, and the error counts those that may have been missed. */
class SparseLightTest {

    private static final Renderer RENDERER = new Renderer(2);
    private static final RenderSettings SMALL = RenderSettings.DEFAULT.withSize(128, 96);
    private static final double HALF_WIDTH = Math.tan(Math.toRadians(30));

    @AfterAll
    static void close() {
        RENDERER.close();
    }

    /**
     * A sphere of radius r at (x, y, z) is seen as an ellipse of the area pi r^2 sqrt(x^2 + y^2 + z^2 - r^2) (z^2 -
     * r^2)^(-3/2) in the plane z = 1.
     */
    @ParameterizedTest
    @CsvSource({"1000, 0.01, 0.002", "400, 0.05, 0.005"})
    void mistOfTinySpheresKeepsItsLight(int count, double radius, double error) throws InterruptedException {
        SplittableRandom random = new SplittableRandom(7);
        List<SceneObject> spheres = new ArrayList<>();
        double area = 0;
        for (int i = 0; i < count; i++) {
            double z = random.nextDouble(8, 20);
            double x = 0.98 * HALF_WIDTH * z * random.nextDouble(-1, 1);
            double y = 0.98 * 0.75 * HALF_WIDTH * z * random.nextDouble(-1, 1);
            spheres.add(new Sphere("light", new Vector3d(x, y, z), radius, new LuminousSurface(Colour.WHITE, false)));
            area += Math.PI
                    * radius
                    * radius
                    * Math.sqrt(x * x + y * y + z * z - radius * radius)
                    / Math.pow(z * z - radius * radius, 1.5);
        }
        Studio studio = studio(60).withScene(spheres);

        RenderJob job = RENDERER.render(RenderPlan.of(studio), new Quality.TargetError(error));

        assertThat(mean(job.image())).isCloseTo(area / (3 * HALF_WIDTH * HALF_WIDTH), withinPercentage(2));
        assertThat(job.report().error()).isLessThanOrEqualTo(error);
        assertThat(PictureDifference.ofLight(job.image(), many(studio))).isLessThan(1.25 * error);
    }

    /** Stars of one pixel in a panorama that is not filtered, before a fast camera: 1 in 1000 pixels. */
    @Test
    void skyOfStarsKeepsItsLight() throws InterruptedException {
        SplittableRandom random = new SplittableRandom(8);
        float[] rgba = new float[4 * 2048 * 1024];
        for (int i = 0; i < rgba.length; i += 4) {
            float light = random.nextInt(1000) == 0 ? 1 : 0;
            rgba[i] = light;
            rgba[i + 1] = light;
            rgba[i + 2] = light;
            rgba[i + 3] = 1;
        }
        PixelPicture stars = new PixelPicture("stars.png", 2048, 1024, rgba, new byte[0]);
        Studio studio = Descriptions.with(studio(90), "background", new PanoramaBackground(stars, false))
                .withVelocity(Velocity.of(0, 0, 0.9));

        RenderJob job = RENDERER.render(RenderPlan.of(studio), new Quality.TargetError(0.003));

        LinearImage right = many(studio);
        assertThat(mean(job.image())).isCloseTo(mean(right), withinPercentage(3));
        assertThat(PictureDifference.ofLight(job.image(), right)).isLessThan(1.25 * 0.003);
        assertThat(job.report().error()).isBetween(0.5 * PictureDifference.ofLight(job.image(), right), 0.003);
    }

    /**
     * A flash of 1 % of the exposure, which lights all that a lamp that is always on does: pixels whose first samples
     * missed it must not stop first, or the mean of many seeds would be too dark.
     */
    @Test
    void aShortFlashIsNotDarkened() throws InterruptedException {
        Pulse flash = new Pulse(0, 0.1, 0);
        Studio studio = Studios.dark()
                .withScene(List.of(
                        new Plane("wall", new Vector3d(0, 0, 10), new Vector3d(0, 0, -1), ColouredSurface.DEFAULT)))
                .withCamera(Descriptions.with(
                        ThinLensCamera.DEFAULT.withShutter(new AperturePlaneShutter(15)), "exposureTime", 10.0))
                .withSettings(RenderSettings.DEFAULT.withSize(48, 36));
        Studio lit = Lighting.of(studio, List.of(lamp(AlwaysOn.DEFAULT)));
        double always =
                mean(RENDERER.render(RenderPlan.of(lit), new Quality.Samples(1)).image());

        assertThat(meanOfSeeds(Lighting.of(studio, List.of(lamp(flash)))))
                .isCloseTo(0.01 * always, withinPercentage(0.5));
    }

    /** A bar that covers 1/60 of each of sixteen pixels. */
    @Test
    void aThinBarIsNotDarkened() throws InterruptedException {
        double high = 2 * HALF_WIDTH / 16 / 60;
        Studio studio = studio(60)
                .withScene(List.of(new Parallelogram(
                        "bar",
                        new Vector3d(-2, -0.005, 1),
                        new Vector3d(4, 0, 0),
                        new Vector3d(0, high, 0),
                        new LuminousSurface(Colour.WHITE, false))))
                .withSettings(RenderSettings.DEFAULT.withSize(16, 1));

        assertThat(meanOfSeeds(studio)).isCloseTo(1.0 / 60, withinPercentage(0.5));
    }

    private static PointLight lamp(Flash flash) {
        return new PointLight(new Vector3d(0, 0, -1), Colour.WHITE, Colour.BLACK, 1, flash);
    }

    /** The mean light of twenty pictures with an error of 0.005. */
    private static double meanOfSeeds(Studio studio) throws InterruptedException {
        double sum = 0;
        for (int seed = 0; seed < 20; seed++) {
            Studio seeded = studio.withSettings(studio.settings().withSeed(seed));
            sum += mean(RENDERER.render(RenderPlan.of(seeded), new Quality.TargetError(0.005))
                    .image());
        }
        return sum / 20;
    }

    private static Studio studio(double angle) {
        return Studios.dark()
                .withCamera(Descriptions.with(ThinLensCamera.DEFAULT, "horizontalAngleDegrees", angle))
                .withSettings(SMALL);
    }

    private static LinearImage many(Studio studio) throws InterruptedException {
        Studio other = studio.withSettings(studio.settings().withSeed(77));
        return RENDERER.render(RenderPlan.of(other), new Quality.Samples(256)).image();
    }

    private static double mean(LinearImage image) {
        double sum = 0;
        for (float value : image.rgb()) {
            sum += value;
        }
        return sum / image.rgb().length;
    }
}
