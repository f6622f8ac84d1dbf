package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Font;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.awt.geom.Rectangle2D;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
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

/** The chart of the picture on show, in a real window: it grows while it is measured. */
@Timeout(300)
@NeedsDisplay
class QualityWindowTest {

    @TempDir
    private Path folder;

    @AutoClose
    private WindowDriver driver;

    @BeforeEach
    void open() {
        Studio studio = Studios.sphere().withSettings(Studio.DEFAULT.settings().withSize(160, 16));
        driver = new WindowDriver(folder, studio, folder.resolve("sphere.json"), List.of(studio));
        JButton measure = driver.find(JButton.class, "Chart this picture");
        WindowDriver.onEventThread(() -> measure.doClick());
    }

    @AfterEach
    void closeDialogs() {
        WindowDriver.onEventThread(() -> dialogs().forEach(JDialog::dispose));
    }

    @Test
    void pointsAppearWhileTheyAreMeasured() {
        WindowDriver.await(
                "points of both curves", () -> entity("where needed", 0) != null && entity("the same", 0) != null);
        assertThat(driver.studio().settings().samples()).isEqualTo(1);
        WindowDriver.await(
                "all points", () -> state().startsWith("Click a point") && entity("where needed", 5) != null);
    }

    @Test
    void thePictureIsAsGoodAsWanted() {
        JTextField error = driver.find(JTextField.class, "Target error");
        WindowDriver.onEventThread(() -> {
            error.setText("0.001");
            error.postActionEvent();
        });
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
}
