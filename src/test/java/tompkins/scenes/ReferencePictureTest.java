package tompkins.scenes;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.net.URL;
import javax.imageio.ImageIO;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.image.LinearImage;
import tompkins.image.ToneCurve;
import tompkins.studio.Studio;

/** The paper's figures against pictures that an independent renderer made. */
class ReferencePictureTest {

    private static final double ALLOWED_SHARE = 0.0002;

    @ParameterizedTest
    @CsvSource({"fig1a, fig1a", "fig1b, fig1b", "fig2a, fig2a", "fig3a, fig3a_pinhole"})
    void figureIsTheReferencePicture(String scene, String reference) throws Exception {
        Studio studio = SceneFiles.withAperture(SceneFiles.withSamples(SceneFiles.read(scene), 1), 0);

        LinearImage picture = SceneFiles.render(studio);

        assertThat(differingPixels(picture, read(reference)))
                .isLessThanOrEqualTo((long) (ALLOWED_SHARE * picture.width() * picture.height()));
    }

    @ParameterizedTest
    @CsvSource({"fig1a, fig1b", "fig1b, fig2a", "fig2a, fig3a_pinhole"})
    void differentFiguresDiffer(String scene, String otherReference) throws Exception {
        LinearImage picture = SceneFiles.render(SceneFiles.withSamples(SceneFiles.read(scene), 1));

        assertThat(differingPixels(picture, read(otherReference))).isGreaterThan(1000);
    }

    private static BufferedImage read(String name) throws IOException {
        URL file = ReferencePictureTest.class.getResource("/reference/" + name + ".png");
        return ImageIO.read(file);
    }

    private static long differingPixels(LinearImage picture, BufferedImage reference) {
        assertThat(reference.getWidth()).isEqualTo(picture.width());
        assertThat(reference.getHeight()).isEqualTo(picture.height());
        long differing = 0;
        for (int y = 0; y < picture.height(); y++) {
            for (int x = 0; x < picture.width(); x++) {
                int difference = 0;
                for (int channel = 0; channel < 3; channel++) {
                    int expected = reference.getRGB(x, y) >> (16 - 8 * channel) & 0xff;
                    int level = ToneCurve.LINEAR.quantise(picture.value(x, y, channel), 255);
                    difference = Math.max(difference, Math.abs(level - expected));
                }
                differing += difference > 1 ? 1 : 0;
            }
        }
        return differing;
    }
}
