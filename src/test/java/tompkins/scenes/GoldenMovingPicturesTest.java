package tompkins.scenes;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.net.URI;
import java.net.URL;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.image.LinearImage;
import tompkins.image.ToneCurve;
import tompkins.io.StudioReader;
import tompkins.studio.Studio;
import tompkins.studio.View;

/** Pictures of a world in motion against those of an independent renderer, where rounding does not decide. */
class GoldenMovingPicturesTest {

    private static final double ALLOWED_SHARE = 0.0002;

    @ParameterizedTest
    @ValueSource(
            strings = {
                "clocks",
                "cube-measured",
                "cube-passed",
                "cube-passes",
                "flash-ring",
                "flash-train",
                "moving-lamp",
                "two-spheres",
                "wheel-measured",
                "wheel-passes"
            })
    void pictureIsTheReferencePicture(String name) throws Exception {
        LinearImage picture = SceneFiles.render(studio(name));

        assertThat(differingPixels(picture, name))
                .isLessThanOrEqualTo((long) (ALLOWED_SHARE * picture.width() * picture.height()));
    }

    @ParameterizedTest
    @CsvSource({"clocks", "cube-passed", "cube-passes", "moving-lamp", "two-spheres", "wheel-passes"})
    void measuredPictureIsAnotherOne(String name) throws Exception {
        LinearImage picture = SceneFiles.render(studio(name).withView(View.MEASURED));

        assertThat(differingPixels(picture, name)).isGreaterThan(500);
    }

    private static URL resource(String file) {
        return GoldenMovingPicturesTest.class.getResource("/golden/moving-pictures/" + file);
    }

    private static Studio studio(String name) throws Exception {
        URI file = resource(name + ".json").toURI();
        return StudioReader.read(Path.of(file));
    }

    private static long differingPixels(LinearImage picture, String name) throws Exception {
        BufferedImage reference = ImageIO.read(resource(name + ".png"));
        BufferedImage unsure = ImageIO.read(resource(name + "-unsure.png"));
        assertThat(reference.getWidth()).isEqualTo(picture.width());
        assertThat(reference.getHeight()).isEqualTo(picture.height());
        long differing = 0;
        for (int y = 0; y < picture.height(); y++) {
            for (int x = 0; x < picture.width(); x++) {
                if ((unsure.getRGB(x, y) & 0xff) == 0 && difference(picture, x, y, reference.getRGB(x, y)) > 1) {
                    differing++;
                }
            }
        }
        return differing;
    }

    private static int difference(LinearImage picture, int x, int y, int reference) {
        int difference = 0;
        for (int channel = 0; channel < 3; channel++) {
            int expected = reference >> (16 - 8 * channel) & 0xff;
            int level = ToneCurve.LINEAR.quantise(picture.value(x, y, channel), 255);
            difference = Math.max(difference, Math.abs(level - expected));
        }
        return difference;
    }
}
