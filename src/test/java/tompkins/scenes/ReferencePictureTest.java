package tompkins.scenes;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
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

/**
 * The paper's figures, and pictures of a world in motion, against those of an independent renderer, where rounding does
 * not decide.
 */
class ReferencePictureTest {

    private static final double ALLOWED_SHARE = 0.0002;
    private static final String MOVING = "/golden/moving-pictures/";

    @ParameterizedTest
    @CsvSource({"fig1a, fig1a", "fig1b, fig1b", "fig2a, fig2a", "fig3a, fig3a_pinhole"})
    void figureIsTheReferencePicture(String scene, String reference) throws Exception {
        Studio studio = SceneFiles.withAperture(SceneFiles.withSamples(SceneFiles.read(scene), 1), 0);
        assertSame(studio, "/reference/" + reference, null);
    }

    @ParameterizedTest
    @CsvSource({"fig1a, fig1b", "fig1b, fig2a", "fig2a, fig3a_pinhole"})
    void differentFiguresDiffer(String scene, String otherReference) throws Exception {
        Studio studio = SceneFiles.withSamples(SceneFiles.read(scene), 1);
        assertThat(differingPixels(studio, "/reference/" + otherReference, null))
                .isGreaterThan(1000);
    }

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
    void movingPictureIsTheReferencePicture(String name) throws Exception {
        assertSame(moving(name), MOVING + name, MOVING + name + "-unsure");
    }

    @ParameterizedTest
    @ValueSource(strings = {"clocks", "cube-passed", "cube-passes", "moving-lamp", "two-spheres", "wheel-passes"})
    void measuredPictureIsAnotherOne(String name) throws Exception {
        assertThat(differingPixels(moving(name).withView(View.MEASURED), MOVING + name, MOVING + name + "-unsure"))
                .isGreaterThan(500);
    }

    private static URL resource(String file) {
        return ReferencePictureTest.class.getResource(file);
    }

    private static Studio moving(String name) throws Exception {
        return StudioReader.read(Path.of(resource(MOVING + name + ".json").toURI()));
    }

    private static void assertSame(Studio studio, String reference, String unsure) throws Exception {
        int pixels = studio.settings().width() * studio.settings().height();
        assertThat(differingPixels(studio, reference, unsure)).isLessThanOrEqualTo((long) (ALLOWED_SHARE * pixels));
    }

    /** How many pixels differ, but for those of which the other renderer was not sure. */
    private static long differingPixels(Studio studio, String name, String unsureName) throws Exception {
        LinearImage picture = SceneFiles.render(studio);
        BufferedImage reference = ImageIO.read(resource(name + ".png"));
        BufferedImage unsure = unsureName == null ? null : ImageIO.read(resource(unsureName + ".png"));
        assertThat(reference.getWidth()).isEqualTo(picture.width());
        assertThat(reference.getHeight()).isEqualTo(picture.height());
        long differing = 0;
        for (int y = 0; y < picture.height(); y++) {
            for (int x = 0; x < picture.width(); x++) {
                boolean isSure = unsure == null || (unsure.getRGB(x, y) & 0xff) == 0;
                if (isSure && difference(picture, x, y, reference.getRGB(x, y)) > 1) {
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
