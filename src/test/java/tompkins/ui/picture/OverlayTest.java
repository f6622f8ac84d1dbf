package tompkins.ui.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tompkins.image.LinearImage;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.trace.RenderPlan;
import tompkins.ui.WindowDriver;
import tompkins.ui.widget.Look;

/** What is drawn over pictures lies where it should. */
class OverlayTest {

    private static final int WIDTH = 640;
    private static final int HEIGHT = 480;

    /** Lines are written above and below it. */
    private static final Rectangle FREE = new Rectangle(0, 30, WIDTH, HEIGHT - 60);

    @BeforeEach
    void install() {
        WindowDriver.onEventThread(() -> Look.LIGHT.install());
    }

    private static BufferedImage painted(Overlay overlay, Studio studio) {
        return painted(overlay, studio, new Rectangle(WIDTH, HEIGHT));
    }

    private static BufferedImage painted(Overlay overlay, Studio studio, Rectangle free) {
        Studio large = studio.withSettings(studio.settings().withSize(WIDTH, HEIGHT));
        LinearImage image = new LinearImage(WIDTH, HEIGHT, new float[3 * WIDTH * HEIGHT]);
        Picture picture = new Picture(large, RenderPlan.of(large), image, true, Duration.ZERO, 1, 0, List.of());
        BufferedImage canvas = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = canvas.createGraphics();
        g.setColor(Color.GRAY);
        g.fillRect(0, 0, WIDTH, HEIGHT);
        overlay.paint(g, picture, new Rectangle(WIDTH, HEIGHT), new Rectangle(WIDTH, HEIGHT), free);
        g.dispose();
        return canvas;
    }

    /** The rectangle around what was painted. */
    private static Rectangle marked(BufferedImage canvas) {
        Rectangle all = new Rectangle(-1, -1);
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                if (canvas.getRGB(x, y) != Color.GRAY.getRGB()) {
                    all = all.union(new Rectangle(x, y, 1, 1));
                }
            }
        }
        return all;
    }

    private static VelocityArrow arrow() {
        VelocityArrow arrow = new VelocityArrow();
        arrow.setShown(true);
        return arrow;
    }

    private static Studio flying(double x, double y, double z) {
        return Studios.sphere().withVelocity(Velocity.of(x, y, z));
    }

    @Test
    void ringLiesWhereTheCameraFlies() {
        // a tenth to the right of the view: 0.1/tan(10 degrees) of half the width
        Rectangle ring = marked(painted(arrow(), flying(0.05, 0, 0.5)));
        int x = (int) Math.round(320 + 320 * 0.1 / Math.tan(Math.toRadians(10)));
        assertThat(ring.x).isBetween(x - 14, x - 9);
        assertThat(ring.y).isBetween(240 - 14, 240 - 9);
        Rectangle tail = marked(painted(arrow(), flying(-0.05, 0, -0.5)));
        assertThat(tail).as("ring around the tail, and an arrow").isNotEqualTo(ring);
        assertThat(tail.contains(x, 240)).isTrue();
    }

    @Test
    void arrowAtTheEdgePointsOutOfThePicture() {
        Rectangle right = marked(painted(arrow(), flying(0.5, 0, 0)));
        assertThat(right.getMaxX()).isBetween(620.0, 630.0);
        assertThat(right.y + right.height / 2).isBetween(238, 242);
        Rectangle up = marked(painted(arrow(), flying(0, 0.5, 0)));
        assertThat(up.y).isBetween(10, 16);
    }

    @Test
    void nothingIsDrawnAtRestOrIfItIsNotWanted() {
        assertThat(marked(painted(arrow(), Studios.sphere())).isEmpty()).isTrue();
        assertThat(marked(painted(new VelocityArrow(), flying(0, 0, 0.5))).isEmpty())
                .isTrue();
        assertThat(marked(painted(new SideMap(), flying(0, 0, 0.5))).isEmpty()).isTrue();
    }

    @Test
    void mapAndLineLeaveRoomForWhatIsWritten() {
        SideMap map = new SideMap();
        map.setShown(true);
        assertThat(FREE.contains(marked(painted(map, Studios.sphere(), FREE)))).isTrue();
        Rectangle line = marked(painted(new RideHeadUp(() -> "on board"), Studios.sphere(), FREE));
        assertThat(line.isEmpty()).isFalse();
        assertThat(FREE.contains(line)).isTrue();
    }

    /** The sphere lies in front of the camera: in the map to the right of the lens, which is white. */
    @Test
    void mapShowsTheSceneFromItsRightSide() {
        SideMap map = new SideMap();
        map.setShown(true);
        BufferedImage canvas = painted(map, Studios.sphere());
        Rectangle place = marked(canvas);
        assertThat(place.getMaxX()).isBetween(620.0, 640.0);
        assertThat(place.getMaxY()).isBetween(460.0, 480.0);
        int lens = -1;
        for (int x = place.x; x < place.getMaxX(); x++) {
            for (int y = place.y; y < place.getMaxY(); y++) {
                lens = lens < 0 && canvas.getRGB(x, y) == Color.WHITE.getRGB() ? x : lens;
            }
        }
        assertThat(lens).isBetween(place.x, place.x + place.width / 3);
    }
}
