package tompkins.ui.ray;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.stream.IntStream;
import javax.swing.UIManager;
import org.junit.jupiter.api.Test;
import tompkins.trace.Frame;
import tompkins.ui.LightLook;
import tompkins.ui.WindowDriver;

/** What is painted where: the event at the lens in the middle near the top, light at 45 degrees, the past below. */
@LightLook
class DiagramPaneTest {

    private static final int SIZE = 200;
    private static final Point2D HERE = new Point2D.Double();
    private static final List<Point2D> LIGHT = List.of(new Point2D.Double(1, 1), new Point2D.Double(-1, 1));

    private static DiagramPane pane(SpaceTimeDiagram diagram) {
        DiagramPane pane = new DiagramPane(10);
        pane.show(diagram, "");
        return pane;
    }

    private static SpaceTimeDiagram along(List<Point2D> path, Point2D onwards) {
        return diagram(Frame.SCENE, path, onwards, null, new Point2D.Double(0, 1), new Point2D.Double(1, 0));
    }

    private static SpaceTimeDiagram diagram(
            Frame frame, List<Point2D> path, Point2D onwards, Point2D object, Point2D otherTime, Point2D otherSpace) {
        return new SpaceTimeDiagram(
                frame,
                SpaceTimeDiagram.around(path),
                path,
                onwards,
                object,
                LIGHT,
                List.of(HERE),
                otherTime,
                otherSpace,
                List.of(),
                List.of());
    }

    private static BufferedImage painted(DiagramPane pane) {
        return WindowDriver.onEventThread(() -> {
            pane.setSize(SIZE, SIZE);
            BufferedImage image = new BufferedImage(SIZE, SIZE, BufferedImage.TYPE_INT_RGB);
            Graphics2D g = image.createGraphics();
            pane.paint(g);
            g.dispose();
            return image;
        });
    }

    /**
     * The row of the event at the lens: that of the horizontal axis, the only one with one colour from left to right.
     */
    private static int lens(BufferedImage image) {
        for (int y = 5; y < SIZE - 5; y++) {
            if (image.getRGB(5, y) == image.getRGB(20, y) && image.getRGB(5, y) != Color.WHITE.getRGB()) {
                return y;
            }
        }
        throw new AssertionError("no axis");
    }

    /** Whether the ray is painted at a place or beside it. */
    private static boolean isRay(BufferedImage image, int x, int y) {
        int ray = UIManager.getColor("Component.accentColor").getRGB();
        return IntStream.range(0, 9).anyMatch(i -> image.getRGB(x - 1 + i % 3, y - 1 + i / 3) == ray);
    }

    @Test
    void lightAlongXRunsDownAtFortyFiveDegrees() {
        BufferedImage image = painted(pane(along(List.of(HERE, new Point2D.Double(9, -9)), null)));
        int row = lens(image);
        assertThat(row).isLessThan(SIZE / 3);
        assertThat(isRay(image, SIZE / 2 + 40, row + 40)).isTrue();
        assertThat(isRay(image, SIZE / 2 - 40, row + 40)).isFalse();
        assertThat(isRay(image, SIZE / 2 + 10, row - 10)).isFalse();
        assertThat(isRay(image, SIZE / 2 + 98, row + 98)).as("behind its end").isFalse();
    }

    /** It passes the end of the ray, 40 pixels below and to the right of the lens, with half the speed of light. */
    @Test
    void theWorldLineOfTheObjectRunsThroughTheEnd() {
        DiagramPane pane = pane(diagram(
                Frame.SCENE,
                List.of(HERE, new Point2D.Double(9, -9)),
                null,
                new Point2D.Double(-0.5, 1),
                new Point2D.Double(0, 1),
                new Point2D.Double(1, 0)));
        BufferedImage image = painted(pane);
        Line2D worldLine = pane.object().get(0);
        int row = lens(image);
        // the ray at 45 degrees ends where both meet
        int end = IntStream.range(0, SIZE / 2)
                .filter(i -> worldLine.ptLineDist(SIZE / 2.0 + i, row + i) < 1)
                .findFirst()
                .orElseThrow();
        assertThat(isRay(image, SIZE / 2 + end - 6, row + end - 6)).isTrue();
        assertThat(isAccent(image, SIZE / 2 + end - 20, row + end - 40)).isTrue();
        assertThat(isAccent(image, SIZE / 2 + end - 4, row + end - 40))
                .as("upright")
                .isFalse();
    }

    /** Whether the colour of the ray is seen at a place or beside it, mixed with white where a line is thin. */
    private static boolean isAccent(BufferedImage image, int x, int y) {
        return IntStream.range(0, 9)
                .map(i -> image.getRGB(x - 1 + i % 3, y - 1 + i / 3))
                .anyMatch(colour -> (colour & 255) - (colour >> 16 & 255) > 60);
    }

    @Test
    void aRayToTheBackgroundRunsToTheEdge() {
        BufferedImage image = painted(pane(along(List.of(HERE), new Point2D.Double(-0.5, -1))));
        int row = lens(image);
        assertThat(isRay(image, SIZE / 2 - 20, row + 40)).isTrue();
        assertThat(isRay(image, SIZE / 2 - 70, row + 140)).isTrue();
    }

    /** At beta = 0.3 the way of the scene leaves the picture of the camera frame at its lower edge. */
    @Test
    void theNameOfTheScenesTimeStandsBesideItsAxisAndInside() {
        double gamma = 1 / Math.sqrt(1 - 0.3 * 0.3);
        BufferedImage image = painted(pane(diagram(
                Frame.CAMERA,
                List.of(HERE, new Point2D.Double(0, -9)),
                null,
                null,
                new Point2D.Double(-0.3 * gamma, gamma),
                new Point2D.Double(gamma, -0.3 * gamma))));
        int axisAtTheEdge = SIZE / 2 + (int) (0.3 * (SIZE - lens(image)));
        assertThat(isEmpty(image, axisAtTheEdge + 4, SIZE - 30, 20, 26)).isFalse();
        assertThat(isEmpty(image, axisAtTheEdge - 32, SIZE - 20, 20, 16)).isTrue();
    }

    /** At all speeds, in both frames, for light from ahead, from aside and from behind. */
    @Test
    void wordsStandOffTheLinesAndOffEachOther() {
        for (double beta :
                new double[] {-0.999, -0.9, -0.6, -0.2, 0.001, 0.1, 0.3, 0.5, 0.7, 0.8, 0.9, 0.99, 0.99999}) {
            double gamma = 1 / Math.sqrt((1 - beta) * (1 + beta));
            for (Frame frame : Frame.values()) {
                int sign = frame == Frame.SCENE ? 1 : -1;
                for (double x : new double[] {-9, -3, 0, 5, 9}) {
                    requireRoomForWords(diagram(
                            frame,
                            List.of(HERE, new Point2D.Double(x, -9)),
                            null,
                            new Point2D.Double(0.1 * x, 1),
                            new Point2D.Double(sign * gamma * beta, gamma),
                            new Point2D.Double(gamma, sign * gamma * beta)));
                }
            }
        }
    }

    private static void requireRoomForWords(SpaceTimeDiagram diagram) {
        DiagramPane pane = pane(diagram);
        Font font = UIManager.getFont("small.font");
        pane.setSize(24 * font.getSize(), 13 * font.getSize());
        List<Rectangle2D> words = pane.words(pane.getFontMetrics(font)).stream()
                .map(DiagramPane.Word::place)
                .toList();
        assertThat(words).as("four names, and numbers").hasSizeGreaterThanOrEqualTo(5);
        for (Rectangle2D word : words) {
            assertThat(pane.getBounds().contains(word)).isTrue();
            assertThat(pane.lines()).noneMatch(line -> line.intersects(word));
            assertThat(words).filteredOn(word::intersects).containsExactly(word);
        }
    }

    private static boolean isEmpty(BufferedImage image, int x, int y, int width, int height) {
        int[] colours = image.getRGB(x, y, width, height, null, 0, width);
        return IntStream.of(colours).allMatch(colour -> colour == Color.WHITE.getRGB());
    }

    @Test
    void whatIsNotANumberIsNotShown() {
        assertThat(pane(along(List.of(HERE, new Point2D.Double(Double.NaN, -1)), null))
                        .isVisible())
                .isFalse();
        assertThat(pane(null).isVisible()).isFalse();
    }
}
