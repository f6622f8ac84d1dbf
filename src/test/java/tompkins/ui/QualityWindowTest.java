package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Font;
import java.awt.Point;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.nio.file.Path;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.text.BadLocationException;
import org.jfree.chart.ChartPanel;
import org.jfree.chart.entity.XYItemEntity;
import org.jfree.data.xy.XYDataset;
import org.joml.Vector3d;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tompkins.sceneobject.Sphere;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.study.ChartStyle;
import tompkins.surface.ColouredSurface;
import tompkins.ui.widget.Look;

/**
 * The chart of the picture on show, in a real window: it grows while it is measured, and a click on a point is taken.
 */
@Timeout(300)
@NeedsDisplay
class QualityWindowTest {

    private static final int MOST_CLICKS = 5;
    private static final String CHOSEN = "Chosen for the picture: ";
    private static final int REACH = 10;
    private static final long CLICK_NANOSECONDS = 3_000_000_000L;

    @TempDir
    private Path folder;

    @AutoClose
    private WindowDriver driver;

    @BeforeEach
    void open() {
        Studio studio = Studios.lattice().withSettings(Studio.DEFAULT.settings().withSize(160, 120));
        driver = new WindowDriver(folder, studio, folder.resolve("lattice.json"), List.of(studio));
        JButton measure = driver.find(JButton.class, "Chart this picture");
        WindowDriver.onEventThread(() -> measure.doClick());
    }

    @AfterEach
    void closeDialogs() {
        WindowDriver.onEventThread(() -> dialogs().forEach(JDialog::dispose));
    }

    @Test
    void aClickOnAPointIsTaken() {
        WindowDriver.await(
                "points of both curves", () -> entity("where needed", 0) != null && entity("the same", 0) != null);
        assertThat(driver.studio().settings().samples()).isEqualTo(1);

        WindowDriver.await(
                "all points", () -> state().startsWith("Click a point") && entity("where needed", 5) != null);
        choose("the same", 0, "4 samples per pixel");
        assertThat(driver.studio().settings().samples()).isEqualTo(4);

        JTextField samples = driver.find(JTextField.class, "Samples");
        WindowDriver.onEventThread(() -> {
            samples.setText("3");
            samples.postActionEvent();
        });
        assertThat(WindowDriver.onEventThread(QualityWindowTest::state))
                .as("when the scene has another number")
                .startsWith("Click a point");

        choose("where needed", 5, "Samples where they are needed, error 0.001");
        WindowDriver.await(
                "a picture that is as good",
                () -> driver.picture().complete() && driver.picture().error() <= 0.001);
    }

    @Test
    void aLargeChartIsDrawnAsLargeAsItIs() {
        WindowDriver.await("a point", () -> entity("the same", 0) != null);
        WindowDriver.onEventThread(() -> {
            dialog().setSize(2400, 1800);
            dialog().validate();
            ChartPanel chart = chart();
            chart.paintImmediately(0, 0, chart.getWidth(), chart.getHeight());
            assertThat(chart.getWidth()).isGreaterThan(2300);
            assertThat(chart.getScaleX()).isEqualTo(1);
            assertThat(chart.getScaleY()).isEqualTo(1);
        });
    }

    @Test
    void theChartFollowsTheLook() {
        WindowDriver.await("a point", () -> entity("the same", 0) != null);
        WindowDriver.onEventThread(() -> {
            Font before = chart().getChart().getTitle().getFont();
            Look.DARK.install();
            assertThat(chart().getChart().getBackgroundPaint()).isEqualTo(ChartStyle.DARK.paper());
            Look.PROJECTOR.install();
            assertThat(chart().getChart().getBackgroundPaint()).isEqualTo(Color.WHITE);
            assertThat(chart().getChart().getTitle().getFont().getSize()).isGreaterThan(before.getSize());
            Look.LIGHT.install();
        });
    }

    @Test
    void allThatIsSaidIsRead() {
        WindowDriver.await("all points", () -> state().startsWith("Click a point"));
        WindowDriver.onEventThread(() -> {
            // where the longest sentence takes two lines
            dialog().setSize(500, 600);
            dialog().validate();
            JTextArea text = Components.find(dialog().getContentPane(), JTextArea.class, "state");
            Rectangle2D end;
            try {
                end = text.modelToView2D(text.getDocument().getLength());
            } catch (BadLocationException e) {
                throw new AssertionError(e);
            }
            assertThat(end.getMaxX()).isLessThanOrEqualTo(text.getWidth());
            assertThat(end.getMaxY()).isLessThanOrEqualTo(text.getHeight());
            assertThat(end.getY()).as("a second line").isPositive();
        });
    }

    @Test
    void anotherChartTakesItsPlace() {
        JDialog first = WindowDriver.onEventThread(QualityWindowTest::dialog);
        JButton measure = driver.find(JButton.class, "Chart this picture");
        WindowDriver.onEventThread(() -> measure.doClick());
        assertThat(WindowDriver.onEventThread(first::isDisplayable)).isFalse();
        assertThat(WindowDriver.onEventThread(() -> dialogs().count())).isEqualTo(1);
        assertThat(WindowDriver.onEventThread(() -> chart().getPopupMenu())).isNull();
    }

    @Test
    void aSceneThatCannotBePicturedIsToldInTheChart() {
        Sphere huge = new Sphere("sphere", new Vector3d(0, 0, 10), 1e200, ColouredSurface.DEFAULT);
        Studio impossible = driver.studio().withScene(List.of(huge));
        JButton measure = driver.find(JButton.class, "Chart this picture");
        WindowDriver.onEventThread(() -> {
            driver.window().model().set(impossible);
            measure.doClick();
        });
        WindowDriver.await("the message", () -> state().contains("scene[0]"));
    }

    @Test
    void escapeClosesTheChart() {
        WindowDriver.await("the focus", () -> dialog().isFocused());
        driver.key(KeyEvent.VK_ESCAPE);
        WindowDriver.await("the end of the chart", () -> dialogs().findAny().isEmpty());
    }

    /** Clicks on a point, and again if the chart was just drawn anew between press and release and took no click. */
    private void choose(String curve, int point, String chosen) {
        for (int click = 0; click < MOST_CLICKS && !isChosen(chosen); click++) {
            WindowDriver.anchor(WindowDriver.onEventThread(QualityWindowTest::chart));
            Point place = WindowDriver.onEventThread(() -> place(curve, point));
            // no event tells of a mouse that is there already
            driver.move(new Point(place.x, place.y + 1));
            driver.move(place);
            awaitState("Click to use: " + chosen);
            driver.click(place);
            awaitState(CHOSEN + chosen);
        }
        assertThat(WindowDriver.onEventThread(QualityWindowTest::state)).isEqualTo(CHOSEN + chosen);
    }

    private static void awaitState(String expected) {
        long end = System.nanoTime() + CLICK_NANOSECONDS;
        WindowDriver.await("an answer", () -> state().equals(expected) || System.nanoTime() > end);
    }

    private static boolean isChosen(String chosen) {
        return WindowDriver.onEventThread(() -> state().equals(CHOSEN + chosen));
    }

    private static Stream<JDialog> dialogs() {
        return Stream.of(Window.getWindows())
                .filter(window -> "quality".equals(window.getName()) && window.isVisible())
                .map(JDialog.class::cast);
    }

    private static JDialog dialog() {
        return dialogs().findFirst().orElseThrow();
    }

    private static ChartPanel chart() {
        return Components.find(dialog().getContentPane(), ChartPanel.class, "chart");
    }

    private static String state() {
        return Components.find(dialog().getContentPane(), JTextArea.class, "state")
                .getText();
    }

    /** A point of a curve, the cheapest first, or null if it is not there yet. */
    private static XYItemEntity entity(String curve, int point) {
        return points().filter(item -> item.getItem() == point
                        && item.getDataset()
                                .getSeriesKey(item.getSeriesIndex())
                                .toString()
                                .startsWith(curve))
                .findFirst()
                .orElse(null);
    }

    /** The points of the curves, without those of the front. */
    private static Stream<XYItemEntity> points() {
        if (chart().getChart() == null) {
            return Stream.empty();
        }
        XYDataset curves = chart().getChart().getXYPlot().getDataset();
        Collection<?> entities =
                chart().getChartRenderingInfo().getEntityCollection().getEntities();
        return entities.stream()
                .filter(XYItemEntity.class::isInstance)
                .map(XYItemEntity.class::cast)
                .filter(point -> point.getDataset() == curves);
    }

    private static Point place(String curve, int point) {
        // the places of the points are those of the last painting, which a new chart may still be waiting for
        chart().paintImmediately(0, 0, chart().getWidth(), chart().getHeight());
        XYItemEntity wanted = entity(curve, point);
        Point place = placeNear(wanted);
        Point corner = chart().getLocationOnScreen();
        return new Point((int) (corner.x + chart().getInsets().left + place.x * chart().getScaleX()), (int)
                (corner.y + chart().getInsets().top + place.y * chart().getScaleY()));
    }

    /** The place nearest to a point that is clearly nearer to it than to any other. */
    private static Point placeNear(XYItemEntity wanted) {
        Point2D centre = centre(wanted);
        return IntStream.rangeClosed(-REACH, REACH)
                .boxed()
                .flatMap(right -> IntStream.rangeClosed(-REACH, REACH)
                        .mapToObj(down -> new Point((int) centre.getX() + right, (int) centre.getY() + down)))
                .filter(place -> place.distance(centre) <= REACH
                        && points().filter(point -> point != wanted)
                                .allMatch(point -> place.distance(centre(point)) > place.distance(centre) + 2))
                .min(Comparator.comparingDouble(place -> place.distance(centre)))
                .orElseThrow(() -> new AssertionError("other points cover " + wanted));
    }

    private static Point2D centre(XYItemEntity point) {
        Rectangle2D bounds = point.getArea().getBounds2D();
        return new Point2D.Double(bounds.getCenterX(), bounds.getCenterY());
    }
}
