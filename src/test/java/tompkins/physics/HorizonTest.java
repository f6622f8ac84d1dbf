package tompkins.physics;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.camera.Camera;
import tompkins.camera.CameraMotion;
import tompkins.camera.ThinLensCamera;
import tompkins.ray.Colour;
import tompkins.ray.RayCounts;
import tompkins.render.Quality;
import tompkins.render.RenderJob;
import tompkins.render.Renderer;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.surface.LuminousSurface;
import tompkins.surface.Tiling;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleTracer;

/** A tiled floor up to the horizon, where a pixel sees more tiles than it has samples. */
class HorizonTest {

    private static final int WIDTH = 96;
    private static final int HEIGHT = 72;
    private static final int FINE = 24;

    /** Each so manieth pixel is enough to tell how far pictures are from the mean. */
    private static final int SOME = 31;

    private static Tiling tiles(boolean filtered) {
        LuminousSurface black = new LuminousSurface(Colour.BLACK, false);
        return new Tiling(black, new LuminousSurface(Colour.WHITE, false), 1, 1, filtered);
    }

    private static Photograph floor(Vector3dc beta, boolean filtered) {
        return floor(beta, TransformationLaw.LORENTZ, filtered);
    }

    private static Photograph floor(Vector3dc beta, TransformationLaw law, boolean filtered) {
        SceneObject plane = new Plane("floor", new Vector3d(0, -1, 0), new Vector3d(0, 1, 0), tiles(filtered));
        Studio studio = Photograph.of(
                        List.of(plane),
                        Photograph.pinhole(new Vector3d(0.13, -0.12, 1), 20, 0.3),
                        Velocity.of(beta),
                        WIDTH,
                        HEIGHT)
                .studio();
        return new Photograph(studio.withTransformation(law));
    }

    /**
     * The mean of a pixel from a fine grid of unfiltered samples: a Kronecker lattice, as an aligned grid would beat
     * against the tiles.
     */
    private static double mean(SampleTracer sharp, int column, int row, int samples) {
        double mean = 0;
        for (int i = 0; i < samples; i++) {
            double x = column + (i * 0.7548776662466927) % 1;
            double y = row + (i * 0.5698402909980532) % 1;
            mean += sharp.sample(x, y, 0, 0, 0.5).red() / samples;
        }
        return mean;
    }

    /** In the moving camera the width of a pixel on the floor grows or shrinks with its angle, under both laws. */
    @ParameterizedTest
    @CsvSource({
        "LORENTZ, 0, 0, 0",
        "LORENTZ, 0, 0, 0.9",
        "LORENTZ, 0.1, 0.05, 0.99",
        "LORENTZ, 0, 0, -0.9",
        "GALILEAN, 0, 0, 0.5",
        "GALILEAN, 0, 0, -0.8",
        "GALILEAN, 0.1, 0.05, 0.6"
    })
    void filteredTilesAreTheMeanOfThePixel(TransformationLaw law, double bx, double by, double bz) {
        Vector3d beta = new Vector3d(bx, by, bz);
        SampleTracer filtered = floor(beta, law, true).plan().tracer(new RayCounts());
        SampleTracer sharp = floor(beta, law, false).plan().tracer(new RayCounts());
        double squares = 0;
        int pixels = 0;
        for (int row = 0; row < HEIGHT; row += 3) {
            for (int column = 1; column < WIDTH; column += 5) {
                double smooth =
                        filtered.sample(column + 0.5, row + 0.5, 0, 0, 0.5).red();
                squares += Math.pow(smooth - mean(sharp, column, row, FINE * FINE), 2);
                pixels++;
            }
        }
        assertThat(Math.sqrt(squares / pixels)).isLessThan(0.08);
    }

    /** A filter as wide as the pixel on top of many samples in it would blur tiles twice. */
    @Test
    void moreSamplesComeNearerToTheMeanOfThePixel() throws InterruptedException {
        Vector3d beta = new Vector3d(0.8, 0, 0);
        SampleTracer sharp = floor(beta, false).plan().tracer(new RayCounts());
        RenderPlan plan = floor(beta, true).plan();
        double[] means = IntStream.range(0, WIDTH * HEIGHT / SOME)
                .map(number -> number * SOME)
                .mapToDouble(pixel -> mean(sharp, pixel % WIDTH, pixel / WIDTH, 1 << 13))
                .toArray();
        try (Renderer renderer = new Renderer()) {
            double one = distance(renderer.render(plan, new Quality.Samples(1)), means);
            double few = distance(renderer.render(plan, new Quality.Samples(16)), means);
            double many = distance(renderer.render(plan, new Quality.Samples(256)), means);
            double wanted = distance(renderer.render(plan, new Quality.TargetError(0.01)), means);
            assertThat(one).isLessThan(0.05);
            assertThat(few).isLessThan(one / 2);
            assertThat(many).isLessThan(few / 2);
            assertThat(wanted).as("error found for 0.01").isLessThan(0.0125);
        }
    }

    private static double distance(RenderJob job, double[] means) {
        double squares = 0;
        for (int number = 0; number < means.length; number++) {
            int pixel = number * SOME;
            double difference = job.image().value(pixel % WIDTH, pixel / WIDTH, 0) - means[number];
            squares += difference * difference / means.length;
        }
        return Math.sqrt(squares);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.9})
    void horizonIsGreyWithoutMoire(double speed) {
        ThinLensCamera camera = Photograph.pinhole(new Vector3d(0, -1e-4, 1), 2e-3, 0);
        SceneObject filtered = new Plane("floor", new Vector3d(0, -1, 0), new Vector3d(0, 1, 0), tiles(true));
        SceneObject sharp = new Plane("floor", new Vector3d(0, -1, 0), new Vector3d(0, 1, 0), tiles(false));
        float[] smooth = Photograph.of(List.of(filtered), camera, Velocity.of(0, 0, speed), 64, 48)
                .image()
                .rgb();
        float[] moire = Photograph.of(List.of(sharp), camera, Velocity.of(0, 0, speed), 64, 48)
                .image()
                .rgb();
        double spreadOfSmooth = 0;
        double spreadOfMoire = 0;
        for (int i = 0; i < smooth.length; i++) {
            spreadOfSmooth = Math.max(spreadOfSmooth, Math.abs(smooth[i] - 0.5));
            spreadOfMoire = Math.max(spreadOfMoire, Math.abs(moire[i] - 0.5));
        }
        assertThat(spreadOfMoire).isEqualTo(0.5);
        assertThat(spreadOfSmooth).isLessThan(0.05);
    }

    /** Coordinates beyond the range of an int. */
    @ParameterizedTest
    @ValueSource(doubles = {1e6, 1e9, 1e10, 1e12, -1e6, -1e10, -1e12})
    void farTilesStillAlternate(double x) {
        for (boolean filtered : new boolean[] {true, false}) {
            SceneObject plane = new Plane("floor", new Vector3d(0, -1, 0), new Vector3d(0, 1, 0), tiles(filtered));
            for (int step = 0; step < 4; step++) {
                Camera down = CameraMotion.shifted(
                        Photograph.pinhole(new Vector3d(0, -1, 0), 1, 0), new Vector3d(x + step + 0.5, 0, 0.5));
                Photograph photograph = Photograph.of(List.of(plane), down, Velocity.REST, 1, 1);
                assertThat(photograph.image().value(0, 0, 0)).isEqualTo(step % 2);
            }
        }
    }
}
