package tompkins.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.image.LinearImage;
import tompkins.ray.PixelPicture;
import tompkins.sceneobject.Parallelogram;
import tompkins.sceneobject.SceneObject;
import tompkins.spacetime.Velocity;
import tompkins.surface.PictureSurface;
import tompkins.surface.Surface;

/** Pictures on things: what is transparent, and what a pixel sees of many pixels. */
class PictureTest {

    private static SceneObject wall(double distance, double half, Surface surface) {
        return new Parallelogram(
                "wall",
                new Vector3d(-half, -half, distance),
                new Vector3d(2 * half, 0, 0),
                new Vector3d(0, 2 * half, 0),
                surface);
    }

    private static Photograph ahead(Velocity velocity, int size, double angle, SceneObject... objects) {
        return Photograph.of(
                List.of(objects), Photograph.pinhole(new Vector3d(0, 0, 1), angle, 0), velocity, size, size);
    }

    /** Half of a red picture and half of what is behind it; nothing of a picture that is not there. */
    @ParameterizedTest
    @CsvSource({"0, 0, 1", "0.25, 0.25, 0.75", "0.5, 0.5, 0.5", "1, 1, 0"})
    void whatIsNotOpaqueIsSeenThrough(float opacity, double red, double green) {
        PixelPicture picture = new PixelPicture("sheet", 1, 1, new float[] {1, 0, 0, opacity}, new byte[0]);
        for (boolean filtered : new boolean[] {false, true}) {
            LinearImage seen = ahead(
                            Velocity.REST,
                            3,
                            20,
                            wall(5, 2, new PictureSurface(picture, true, filtered)),
                            wall(9, 4, Photograph.GREEN))
                    .image();
            assertThat(new double[] {seen.value(1, 1, 0), seen.value(1, 1, 1), seen.value(1, 1, 2)})
                    .containsExactly(new double[] {red, green, 0}, within(1e-7));
        }
    }

    /** Two sheets of half opacity, one behind the other, let a quarter pass. */
    @Test
    void sheetsBehindEachOtherMultiply() {
        PixelPicture half = new PixelPicture("sheet", 1, 1, new float[] {0, 0, 1, 0.5f}, new byte[0]);
        Surface sheet = new PictureSurface(half, true, true);
        LinearImage seen = ahead(
                        Velocity.REST, 3, 20, wall(5, 2, sheet), wall(6, 3, sheet), wall(9, 4, Photograph.GREEN))
                .image();
        assertThat(seen.value(1, 1, 1)).isCloseTo(0.25f, within(1e-6f));
        assertThat(seen.value(1, 1, 2)).isCloseTo(0.75f, within(1e-6f));
    }

    /** A mirrored picture on a slanted wall, of large and of small spots, is the picture whose rows are reversed. */
    @ParameterizedTest
    @CsvSource({"true, 15", "true, 90", "false, 15"})
    void mirroredPicturesRunTheOtherWay(boolean filtered, int size) {
        int side = 40;
        float[] rgba = new float[4 * side * side];
        float[] reversed = new float[rgba.length];
        SplittableRandom random = new SplittableRandom(40);
        for (int i = 0; i < rgba.length; i++) {
            rgba[i] = i % 4 == 3 ? 1 : (float) random.nextDouble();
            int column = i / 4 % side;
            reversed[i + 4 * (side - 1 - 2 * column)] = rgba[i];
        }
        PixelPicture picture = new PixelPicture("picture", side, side, rgba, new byte[0]);
        PixelPicture other = new PixelPicture("other", side, side, reversed, new byte[0]);
        LinearImage mirrored = slanted(size, new PictureSurface(picture, true, filtered, true));
        LinearImage expected = slanted(size, new PictureSurface(other, true, filtered));
        LinearImage straight = slanted(size, new PictureSurface(picture, true, filtered));
        double worst = 0;
        double different = 0;
        for (int i = 0; i < expected.rgb().length; i++) {
            worst = Math.max(worst, Math.abs(mirrored.rgb()[i] - expected.rgb()[i]));
            different = Math.max(different, Math.abs(straight.rgb()[i] - expected.rgb()[i]));
        }
        assertThat(worst).isLessThan(1e-5);
        assertThat(different).isGreaterThan(0.2);
    }

    private static LinearImage slanted(int size, Surface surface) {
        SceneObject wall = new Parallelogram(
                "wall", new Vector3d(-2.1, -3, 4), new Vector3d(5, 0.3, 7), new Vector3d(0.2, 6, 0.1), surface);
        return ahead(Velocity.REST, size, 24, wall).image();
    }

    /**
     * A wall of a million black and white pixels, chosen so that a quarter is white: one sample of each pixel has
     * nearly their mean, at rest and for a camera that flies towards it, whose pixels see more of it.
     */
    @ParameterizedTest
    @CsvSource({"0", "0.9", "-0.5"})
    void aPixelSeesTheMeanOfItsFootprint(double beta) {
        int size = 1024;
        float[] rgba = new float[4 * size * size];
        for (int i = 0; i < size * size; i++) {
            boolean white = i % 2 == 0 && i / size % 2 == 0;
            rgba[4 * i] = white ? 1 : 0;
            rgba[4 * i + 3] = 1;
        }
        PixelPicture grid = new PixelPicture("grid", size, size, rgba, new byte[0]);
        Photograph seen = ahead(
                Velocity.of(new Vector3d(0, 0, beta)), 15, 24, wall(10, 40, new PictureSurface(grid, true, true)));
        double worst = 0;
        for (int y = 0; y < 15; y++) {
            for (int x = 0; x < 15; x++) {
                worst = Math.max(worst, Math.abs(seen.image().value(x, y, 0) - 0.25));
            }
        }
        // a footprint of few pixels keeps some of their pattern
        assertThat(worst).isLessThan(0.12);
    }
}
