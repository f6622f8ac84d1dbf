package tompkins.scenes;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import tompkins.image.LinearImage;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.sceneobject.ImagePointGrid;
import tompkins.sceneobject.Sphere;
import tompkins.studio.Studio;
import tompkins.studio.UniformBackground;
import tompkins.surface.LuminousSurface;

/**
 * Fig. 3 of the paper: through a wide aperture the white spheres are as sharp as through a pinhole with the
 * detector-plane shutter, and not with the aperture-plane shutter. The spheres alone are photographed, glowing before
 * black, and the width of each edge is the area of its grey pixels divided by its length.
 */
class SharpnessTest {

    private static final int SAMPLES = 36;
    private static final int ROWS = 9;

    private static double[] pinhole;
    private static double[] detectorPlane;
    private static double[] aperturePlane;

    @BeforeAll
    static void photograph() throws InterruptedException {
        pinhole = edgeWidths(SceneFiles.withAperture(SceneFiles.read("fig3a"), 0));
        detectorPlane = edgeWidths(SceneFiles.read("fig3a"));
        aperturePlane = edgeWidths(SceneFiles.read("fig3b"));
    }

    @Test
    void detectorPlaneShutterKeepsEverySphereSharp() {
        for (int sphere = 0; sphere < pinhole.length; sphere++) {
            assertThat(detectorPlane[sphere]).as("sphere %d", sphere).isLessThan(1.15 * pinhole[sphere]);
        }
    }

    /** All but the sphere on the axis: there the ways through the lens are equally long, but for the second order. */
    @Test
    void aperturePlaneShutterBlursEverySphereOffTheAxis() {
        for (int sphere = 0; sphere < pinhole.length; sphere++) {
            if (sphere != ROWS * ROWS / 2) {
                assertThat(aperturePlane[sphere]).as("sphere %d", sphere).isGreaterThan(1.5 * detectorPlane[sphere]);
            }
        }
    }

    /** Width of the edge of each of the 81 spheres, in pixels. */
    private static double[] edgeWidths(Studio figure) throws InterruptedException {
        ImagePointGrid grid = (ImagePointGrid) figure.scene().get(0);
        Sphere sphere = new Sphere("ball", new Vector3d(), 0.025, new LuminousSurface(Colour.WHITE, false));
        ImagePointGrid glowing =
                new ImagePointGrid("balls", sphere, grid.corner(), grid.spanU(), grid.spanV(), grid.points());
        Studio dark =
                withBlackBackground(SceneFiles.withSamples(figure, SAMPLES).withScene(List.of(glowing)));
        LinearImage picture = SceneFiles.render(dark);
        double[] widths = new double[ROWS * ROWS];
        double pixelsPerSlope = 639 / (2 * Math.tan(Math.toRadians(10)));
        for (int i = 0; i < ROWS; i++) {
            for (int j = 0; j < ROWS; j++) {
                int x = (int) Math.round(319.5 + pixelsPerSlope * (-1 + 0.25 * i) / 10);
                int y = (int) Math.round(239.5 - pixelsPerSlope * (-1 + 0.25 * j) / 10);
                widths[i * ROWS + j] = edgeWidth(picture, x, y);
            }
        }
        return widths;
    }

    private static double edgeWidth(LinearImage picture, int centreX, int centreY) {
        int grey = 0;
        double light = 0;
        int reach = 20;
        for (int y = centreY - reach; y <= centreY + reach; y++) {
            for (int x = centreX - reach; x <= centreX + reach; x++) {
                float value = picture.value(x, y, 0);
                grey += value > 0.1 && value < 0.9 ? 1 : 0;
                light += value;
            }
        }
        double radius = Math.sqrt(light / Math.PI);
        assertThat(radius)
                .as("radius of the sphere at %d, %d", centreX, centreY)
                .isBetween(2.0, 20.0);
        return grey / (2 * Math.PI * radius);
    }

    private static Studio withBlackBackground(Studio studio) {
        return Descriptions.with(studio, "background", new UniformBackground(Colour.BLACK));
    }
}
