package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JTextArea;
import org.jfree.chart.ChartPanel;
import org.jfree.data.xy.XYDataset;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tompkins.TestRun;
import tompkins.measure.MeasureKind;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.ui.compare.ComparePanel;
import tompkins.ui.picture.PictureCanvas;

class MeasureToolTest extends WindowFixture {

    private PictureCanvas canvas;

    @BeforeEach
    void open() {
        Studio studio = Studios.sphere()
                .withVelocity(Velocity.of(0, 0, 0.8))
                .withSettings(Studio.DEFAULT.settings().withSize(640, 480));
        driver = new WindowDriver(folder, new FirstScene(studio, folder.resolve("ball.json")), List.of(studio));
        canvas = driver.find(PictureCanvas.class, "picture");
        driver.completePicture();
        driver.menu("menu.measure");
        await("the panel of measuring", () -> panel().isVisible());
        driver.completePicture();
    }

    private JComponent panel() {
        return driver.find(JComponent.class, "measure");
    }

    private String results() {
        return driver.find(JTextArea.class, "measure.results").getText();
    }

    /** Clicks at a place, as a share of the picture from its middle to its right and its lower edge. */
    private void click(double right, double down) {
        Point point = onEventThread(() -> {
            Rectangle bounds = canvas.pictureBounds();
            Point corner = canvas.getLocationOnScreen();
            return new Point(
                    corner.x + (int) (bounds.getCenterX() + right * bounds.width / 2),
                    corner.y + (int) (bounds.getCenterY() + down * bounds.height / 2));
        });
        driver.click(point);
    }

    /** The angle in a frame: those with the same number stand together. */
    private double angle(String frame) {
        Matcher matcher =
                Pattern.compile("([0-9.]+)[^(\u00b7\n]* \\([a-z, ]*" + frame).matcher(results());
        assertThat(matcher.find()).as(results()).isTrue();
        return Double.parseDouble(matcher.group(1));
    }

    private double number(String label) {
        Matcher matcher =
                Pattern.compile(Pattern.quote(label) + "\u00a0\\(?([0-9.]+)").matcher(results());
        assertThat(matcher.find()).as(results()).isTrue();
        return Double.parseDouble(matcher.group(1));
    }

    /** What the button puts on the clipboard, which is that of the whole screen. */
    private String copied() throws IOException, UnsupportedFlavorException {
        JButton copy = driver.find(JButton.class, "Copy");
        onEventThread(() -> copy.doClick());
        return (String) Toolkit.getDefaultToolkit().getSystemClipboard().getData(DataFlavor.stringFlavor);
    }

    @Test
    void clicksTellAnglesThatFollowTheSpeedAndAreCopied() throws Exception {
        assertThat(results()).isEqualTo("Click on two points in the picture.");
        click(0, 0);
        click(0.5, 0);
        await("the angle", () -> results().startsWith("angle: "));

        double camera = Math.toDegrees(Math.atan(0.5 * Math.tan(Math.toRadians(10))));
        assertThat(angle("camera")).isCloseTo(camera, within(0.1));
        assertThat(angle("scene"))
                .isCloseTo(
                        Math.toDegrees(2 * Math.atan(3 * Math.tan(Math.toRadians(angle("camera")) / 2))), within(0.1));

        driver.set(driver.studio().withVelocity(Velocity.REST));
        await("the angle at rest", () -> angle("scene") == angle("camera"));
        assertThat(results().lines().map(line -> line.substring(0, line.indexOf(':'))))
                .containsExactly(
                        "angle",
                        "distance in scene units",
                        "dt in scene units",
                        "dr\u00b2 - dt\u00b2 in scene units\u00b2");
        assertThat(results().lines()).allMatch(line -> line.indexOf('(') == line.lastIndexOf('('));

        if (TestRun.THOROUGH) {
            assertThat(copied())
                    .startsWith("quantity,value,uncertainty,unit\ncameraAngle,")
                    .contains("\nsceneAngle,");
        }

        // what is measured is no pin
        driver.key(KeyEvent.VK_ESCAPE);
        await("the end", () -> !panel().isVisible());
    }

    @Test
    void circleAndProfileAreMeasured() throws Exception {
        JComboBox<?> kinds = driver.find(JComboBox.class, "What to measure");
        onEventThread(() -> kinds.setSelectedItem(MeasureKind.CIRCLE));
        click(0.3, 0);
        click(-0.3, 0);
        click(0, 0.4);
        await("the circle", () -> results().startsWith("half-angle"));
        double slope = 0.3 * Math.tan(Math.toRadians(10));
        assertThat(number("half-angle")).isCloseTo(Math.toDegrees(Math.atan(slope)), within(0.1));
        JTextArea text = driver.find(JTextArea.class, "measure.results");
        assertThat(text.getWidth()).as("without a chart").isGreaterThan(panel().getWidth() * 9 / 10);

        onEventThread(() -> kinds.setSelectedItem(MeasureKind.PROFILE));
        JButton clear = driver.find(JButton.class, "Clear");
        onEventThread(() -> clear.doClick());
        click(-0.1, 0);
        click(0.9, 0);
        await("the profile", () -> results().startsWith("edge (column, row)"));
        // the ball of 10 degrees at 0.8 c: its edge at the slope of a third of the angle
        double edge = Math.tan(2 * Math.atan(Math.tan(Math.asin(0.1) / 2) / 3));
        assertThat(number("edge (column, row)"))
                .isCloseTo(320 + 320 * edge / Math.tan(Math.toRadians(10)), within(1.5));
        XYDataset curves =
                driver.find(ChartPanel.class, "Profile").getChart().getXYPlot().getDataset();
        assertThat(curves.getSeriesCount()).as("red, green, blue").isEqualTo(3);
        assertThat(curves.getItemCount(0)).isGreaterThan(200);
        await(
                "the room beside the chart",
                () -> text.getWidth() >= panel().getWidth() / 4 && text.getWidth() <= panel().getWidth() / 2);
        if (TestRun.THOROUGH) {
            assertThat(copied())
                    .startsWith("pixel_x [pixels],pixel_y [pixels],")
                    .as("headings, and a line for each place")
                    .hasLineCount(1 + curves.getItemCount(0));
        }
        assertThat(curves.getXValue(0, curves.getItemCount(0) - 1)).isCloseTo(320, within(3.0));
    }

    private String otherResults() {
        return driver.find(JTextArea.class, "measure.other").getText();
    }

    /** Three clicks on a circle about the middle, on one side of it. */
    private void clickArc(double radius, int side) {
        for (int step = -1; step <= 1; step++) {
            double turn = step * Math.PI / 5;
            // a share of the width and of the height of 4:3
            click(side * radius * Math.cos(turn), radius * Math.sin(turn) * 4 / 3);
        }
    }

    /** The picture at 0.8 c is kept; at rest, circles in both halves are compared. */
    @Test
    void sizesInAKeptPictureAreCompared() throws Exception {
        JComboBox<?> kinds = driver.find(JComboBox.class, "What to measure");
        onEventThread(() -> kinds.setSelectedItem(MeasureKind.CIRCLE));
        JComboBox<?> other = driver.find(JComboBox.class, "Compare with");
        onEventThread(() -> other.setSelectedItem(ComparePanel.Other.KEPT_PICTURE));
        driver.set(driver.studio().withVelocity(Velocity.REST));
        driver.completePicture();
        await("both pictures", canvas::showsTwo);
        clickArc(0.6, -1);
        await("the circle", () -> results().startsWith("half-angle"));
        assertThat(otherResults()).startsWith("Kept: ").endsWith("click there, too, and sizes are compared.");

        clickArc(0.2, 1);
        await("the ratio", () -> otherResults().contains("times as large"));

        double here = Math.toDegrees(Math.atan(0.6 * Math.tan(Math.toRadians(10))));
        double there = Math.toDegrees(Math.atan(0.2 * Math.tan(Math.toRadians(10))));
        assertThat(number("half-angle")).isCloseTo(here, within(0.1));
        Matcher both =
                Pattern.compile("half-angle\u00a0([0-9.]+).*here ([0-9.]+)").matcher(otherResults());
        assertThat(both.find()).as(otherResults()).isTrue();
        assertThat(Double.parseDouble(both.group(1))).isCloseTo(there, within(0.1));
        assertThat(Double.parseDouble(both.group(2))).isCloseTo(here / there, within(0.15));
        if (TestRun.THOROUGH) {
            assertThat(copied().lines().filter(line -> line.startsWith("halfAngle,")))
                    .hasSize(2);
        }
    }
}
