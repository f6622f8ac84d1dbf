package tompkins.studio;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
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
        Background panorama = new PanoramaBackground(new PixelPicture("nine", 3, 3, rgba, new byte[0]));
        assertThat(panorama.colour(0, 0, 1)).isEqualTo(new Colour(1, 1, 0));
        assertThat(panorama.colour(1, 0, 0)).isEqualTo(new Colour(2, 1, 0));
        assertThat(panorama.colour(-1, 0, 0)).isEqualTo(new Colour(0, 1, 0));
        // 70 degrees up and down, straight ahead
        double level = Math.cos(Math.toRadians(70));
        double height = Math.sin(Math.toRadians(70));
        assertThat(panorama.colour(0, height, level)).isEqualTo(new Colour(1, 0, 0));
        assertThat(panorama.colour(0, -height, level)).isEqualTo(new Colour(1, 2, 0));
        // just right and just left of straight behind
        assertThat(panorama.colour(1e-9, 0, -1)).isEqualTo(new Colour(2, 1, 0));
        assertThat(panorama.colour(-1e-9, 0, -1)).isEqualTo(new Colour(0, 1, 0));
    }

    @Test
    void aSkyFadesWithTheSineOfTheHeight() {
        Background sky = new SkyBackground(new Colour(0, 0, 1), new Colour(1, 0.5, 0), new Colour(0.1, 0.2, 0.3));
        assertThat(sky.colour(0, 1, 0)).isEqualTo(new Colour(0, 0, 1));
        assertThat(sky.colour(0, 1 + 1e-15, 0)).isEqualTo(new Colour(0, 0, 1));
        assertThat(sky.colour(1, 0, 0)).isEqualTo(new Colour(1, 0.5, 0));
        assertThat(sky.colour(0, 0.25, -Math.sqrt(1 - 0.0625))).isEqualTo(new Colour(0.75, 0.375, 0.25));
        assertThat(sky.colour(0, -1e-9, 1)).isEqualTo(new Colour(0.1, 0.2, 0.3));
    }
}
