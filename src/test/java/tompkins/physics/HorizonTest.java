package tompkins.physics;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.camera.Camera;
import tompkins.camera.ThinLensCamera;
import tompkins.ray.Colour;
import tompkins.ray.RayCounts;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.spacetime.Velocity;
import tompkins.surface.LuminousSurface;
import tompkins.surface.Tiling;
import tompkins.trace.SampleTracer;

/** A tiled floor up to the horizon, where a pixel sees more tiles than it has samples. */
class HorizonTest {

    private static final int WIDTH = 96;
    private static final int HEIGHT = 72;
    private static final int FINE = 24;

    private static Tiling tiles(boolean filtered) {
        LuminousSurface black = new LuminousSurface(Colour.BLACK, false);
        return new Tiling(black, new LuminousSurface(Colour.WHITE, false), 1, 1, filtered);
    }

    private static Photograph floor(Vector3dc beta, boolean filtered) {
        SceneObject plane = new Plane("floor", new Vector3d(0, -1, 0), new Vector3d(0, 1, 0), tiles(filtered));
        return Photograph.of(
                List.of(plane),
                Photograph.pinhole(new Vector3d(0.13, -0.12, 1), 20, 0.3),
                Velocity.of(beta),
                WIDTH,
                HEIGHT);
    }

    /** Rows below the horizon, with the exact mean of each pixel from a fine grid of unfiltered samples. */
    private static double[] errors(Vector3dc beta) {
        SampleTracer filtered = floor(beta, true).plan().tracer(new RayCounts());
        SampleTracer sharp = floor(beta, false).plan().tracer(new RayCounts());
        double filteredSum = 0;
        double sharpSum = 0;
        int pixels = 0;
        for (int row = 0; row < HEIGHT; row += 3) {
            for (int column = 1; column < WIDTH; column += 5) {
                double mean = 0;
                for (int i = 0; i < FINE * FINE; i++) {
                    // a Kronecker lattice: an aligned grid would beat against the tiles
                    double x = column + (i * 0.7548776662466927) % 1;
                    double y = row + (i * 0.5698402909980532) % 1;
                    mean += sharp.sample(x, y, 0, 0).red() / (FINE * FINE);
                }
                double smooth = filtered.sample(column + 0.5, row + 0.5, 0, 0).red();
                double single = sharp.sample(column + 0.5, row + 0.5, 0, 0).red();
                filteredSum += (smooth - mean) * (smooth - mean);
                sharpSum += (single - mean) * (single - mean);
                pixels++;
            }
        }
        return new double[] {Math.sqrt(filteredSum / pixels), Math.sqrt(sharpSum / pixels)};
    }

    /** In the moving camera the width of a pixel on the floor grows or shrinks by the Doppler factor. */
    @ParameterizedTest
    @CsvSource({"0, 0, 0", "0, 0, 0.9", "0.1, 0.05, 0.99", "0, 0, -0.9"})
    void filteredTilesAreTheMeanOfThePixel(double bx, double by, double bz) {
        double[] errors = errors(new Vector3d(bx, by, bz));
        assertThat(errors[0]).as("filtered").isLessThan(0.08);
        assertThat(errors[1]).as("naive: one sharp sample").isGreaterThan(2 * errors[0]);
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
            for (int step = 0; step < 4; step++) {
                Camera down = new ThinLensCamera(
                        new Vector3d(x + step + 0.5, 0, 0.5),
                        new Vector3d(0, -1, 0),
                        new Vector3d(0, 0, 1),
                        1,
                        0,
                        0,
                        ThinLensCamera.DEFAULT.focus(),
                        0,
                        new AperturePlaneShutter(0));
                SceneObject plane = new Plane("floor", new Vector3d(0, -1, 0), new Vector3d(0, 1, 0), tiles(filtered));
                Photograph photograph = Photograph.of(List.of(plane), down, Velocity.REST, 1, 1);
                assertThat(photograph.image().value(0, 0, 0)).isEqualTo(step % 2);
                if (Math.abs(x) > Integer.MAX_VALUE) {
                    assertThat((int) Math.floor(x + step + 0.5))
                            .as("naive: the cast saturates")
                            .isEqualTo((int) Math.floor(x + step + 1.5));
                }
            }
        }
    }
}
