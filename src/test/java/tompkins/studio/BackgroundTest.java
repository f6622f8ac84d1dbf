package tompkins.studio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.light.Star;
import tompkins.property.InvalidPropertyException;
import tompkins.ray.Colour;
import tompkins.ray.PixelPicture;

/** Which way up and round backgrounds are. */
class BackgroundTest {

    /** Three columns and rows: red tells the column, green the row. */
    @Test
    void panoramaLooksAheadWithXAtTheRight() {
        float[] rgba = new float[3 * 3 * 4];
        for (int pixel = 0; pixel < 9; pixel++) {
            rgba[4 * pixel] = pixel % 3;
            rgba[4 * pixel + 1] = pixel / 3;
            rgba[4 * pixel + 3] = 1;
        }
        Background panorama = new PanoramaBackground(new PixelPicture("nine", 3, 3, rgba, new byte[0]), false);
        assertThat(panorama.colour(0, 0, 1, 0)).isEqualTo(new Colour(1, 1, 0));
        assertThat(panorama.colour(1, 0, 0, 0)).isEqualTo(new Colour(2, 1, 0));
        assertThat(panorama.colour(-1, 0, 0, 0)).isEqualTo(new Colour(0, 1, 0));
        // 70 degrees up and down, straight ahead
        double level = Math.cos(Math.toRadians(70));
        double height = Math.sin(Math.toRadians(70));
        assertThat(panorama.colour(0, height, level, 0)).isEqualTo(new Colour(1, 0, 0));
        assertThat(panorama.colour(0, -height, level, 0)).isEqualTo(new Colour(1, 2, 0));
        // just right and just left of straight behind
        assertThat(panorama.colour(1e-9, 0, -1, 0)).isEqualTo(new Colour(2, 1, 0));
        assertThat(panorama.colour(-1e-9, 0, -1, 0)).isEqualTo(new Colour(0, 1, 0));
    }

    /** Against many directions in a cone: ahead, near a pole, and across the edge of the picture. */
    @ParameterizedTest
    @CsvSource({"0.3, 0.2, 1", "0.05, 1, -0.04", "0.02, 0.1, -1"})
    void aFilteredPanoramaShowsTheMeanOfACone(double x, double y, double z) {
        Random random = new Random(20261126);
        int width = 512;
        int height = 256;
        float[] rgba = new float[4 * width * height];
        for (int i = 0; i < rgba.length; i++) {
            rgba[i] = i % 4 == 3 ? 1 : random.nextFloat();
        }
        PixelPicture noise = new PixelPicture("noise", width, height, rgba, new byte[0]);
        Vector3d direction = new Vector3d(x, y, z).normalize();
        for (double angle : new double[] {0.4, 0.8}) {
            double sum = 0;
            int many = 40_000;
            for (int i = 0; i < many; i++) {
                Vector3d aside = new Vector3d(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
                aside.cross(direction).normalize().mul(angle / 2 * Math.sqrt(random.nextDouble()));
                Vector3d inCone = aside.add(direction).normalize();
                sum += new PanoramaBackground(noise, false)
                        .colour(inCone.x, inCone.y, inCone.z, 0)
                        .red();
            }
            double filtered = new PanoramaBackground(noise, true)
                    .colour(direction.x, direction.y, direction.z, angle)
                    .red();
            // one direction alone differs by 0.29
            assertThat(filtered).isCloseTo(sum / many, within(0.03));
        }
    }

    @Test
    void aSkyFadesWithTheSineOfTheHeight() {
        Background sky = new SkyBackground(new Colour(0, 0, 1), new Colour(1, 0.5, 0), new Colour(0.1, 0.2, 0.3));
        assertThat(sky.colour(0, 1, 0, 0)).isEqualTo(new Colour(0, 0, 1));
        assertThat(sky.colour(0, 1 + 1e-15, 0, 0)).isEqualTo(new Colour(0, 0, 1));
        assertThat(sky.colour(1, 0, 0, 0)).isEqualTo(new Colour(1, 0.5, 0));
        assertThat(sky.colour(0, 0.25, -Math.sqrt(1 - 0.0625), 0)).isEqualTo(new Colour(0.75, 0.375, 0.25));
        assertThat(sky.colour(0, -1e-9, 1, 0)).isEqualTo(new Colour(0.1, 0.2, 0.3));
    }

    /** Right ascension 6 h is to the left of 0 h, and 18 h to the right; the pole is up. */
    @Test
    void eastOfAStarSkyIsToTheLeft() {
        assertThat(StarSky.DEFAULT.direction(new Star(0, 0, 1, 0)).distance(0, 0, 1))
                .isLessThan(1e-15);
        assertThat(StarSky.DEFAULT.direction(new Star(90, 0, 1, 0)).distance(-1, 0, 0))
                .isLessThan(1e-15);
        assertThat(StarSky.DEFAULT.direction(new Star(270, 0, 1, 0)).distance(1, 0, 0))
                .isLessThan(1e-15);
        assertThat(StarSky.DEFAULT.direction(new Star(123, 90, 1, 0)).distance(0, 1, 0))
                .isLessThan(1e-15);
    }

    @Test
    void aStarSkyNeedsTwoDirections() {
        Vector3d north = new Vector3d(1, 2, 3);
        assertThatThrownBy(() -> new StarSky(6, 0.2, north, new Vector3d(-2, -4, -6), Colour.BLACK))
                .isInstanceOf(InvalidPropertyException.class)
                .hasMessage("zeroHour must not be parallel to north [1, 2, 3], was [-2, -4, -6]");
        assertThatThrownBy(() -> new StarSky(6.6, 0.2, north, new Vector3d(0, 0, 1), Colour.BLACK))
                .hasMessageContaining("limit must be");
        assertThatThrownBy(() -> new StarSky(6, 0, north, new Vector3d(0, 0, 1), Colour.BLACK))
                .hasMessageContaining("zeroMagnitudeSquareDegrees must be");
    }
}
