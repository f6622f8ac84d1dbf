package tompkins.ui.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Window;
import java.awt.event.ActionEvent;
import java.awt.event.MouseEvent;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.JTextArea;
import javax.swing.KeyStroke;
import org.jfree.chart.ChartPanel;
import org.jfree.chart.plot.XYPlot;
import org.jfree.data.xy.XYDataset;
import org.joml.Vector3d;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import tompkins.sceneobject.Sphere;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.study.Spread;
import tompkins.study.StudyPoint;
import tompkins.surface.ColouredSurface;
import tompkins.ui.Components;
import tompkins.ui.NeedsDisplay;
import tompkins.ui.WindowDriver;
import tompkins.ui.model.StudioModel;
import tompkins.ui.widget.Look;

/** A click on a point of the chart, whose points have times and errors that were never measured. */
@Timeout(600)
@NeedsDisplay
class QualityChartTest {

    private static final StudyPoint SAME = point("the same number everywhere", 4, 0.001, 0.03);
    private static final StudyPoint NEEDED = point("where needed", 0.001, 0.1, 0.001);
    private static final List<StudyPoint> POINTS = List.of(SAME, point("where needed", 0.008, 0.01, 0.01), NEEDED);

    private final StudioModel model = new StudioModel(Studios.sphere(), null);
    private JFrame frame;

    private static StudyPoint point(String method, double setting, double seconds, double error) {
        return new StudyPoint("picture", method, setting, 1e6, Spread.exact(seconds), Spread.exact(error), error, 0);
    }

    @BeforeEach
    void open() {
        WindowDriver.onEventThread(() -> {
            Look.LIGHT.install();
            frame = new JFrame();
            QualityChart.open(model, frame, (study, listener) -> listener.accept(POINTS));
        });
        WindowDriver.await("all points", () -> state().startsWith("Click a point"));
    }

    @AfterEach
    void close() {
        WindowDriver.onEventThread(() -> frame.dispose());
    }

    @Test
    void aClickOnAPointIsTaken() {
        WindowDriver.onEventThread(() -> {
            mouse(SAME, 40);
            assertThat(state()).as("beside it").startsWith("Click a point");
            assertThat(model.studio().settings().samples()).isEqualTo(1);
            mouse(SAME, 0);
            assertThat(model.studio().settings().samples()).isEqualTo(4);
            assertThat(state()).startsWith("The picture has this quality");
            mouse(NEEDED, 0);
            assertThat(model.studio().settings().targetError()).isEqualTo(0.001);
        });
    }

    /** The usual chart grows point by point; Escape ends it. */
    @Test
    void pointsAppearWhileTheyAreMeasured() {
        WindowDriver.onEventThread(() -> {
            dialog().dispose();
            model.set(Studios.sphere().withSettings(Studio.DEFAULT.settings().withSize(160, 16)));
            QualityChart.open(model, frame);
        });
        WindowDriver.await("all points", () -> state().startsWith("Click a point"));
        WindowDriver.onEventThread(() -> {
            ChartPanel chart = Components.find(dialog().getContentPane(), ChartPanel.class, "chart");
            XYDataset curves = chart.getChart().getXYPlot().getDataset();
            assertThat(IntStream.range(0, curves.getSeriesCount())
                            .map(curves::getItemCount)
                            .sum())
                    .isGreaterThan(5);
            dialog().getRootPane()
                    .getActionForKeyStroke(KeyStroke.getKeyStroke("ESCAPE"))
                    .actionPerformed(new ActionEvent(frame, ActionEvent.ACTION_PERFORMED, ""));
        });
        assertThat(Window.getWindows()).noneMatch(window -> "quality".equals(window.getName()) && window.isVisible());
    }

    @Test
    void aSceneThatCannotBePicturedIsToldInTheChart() {
        Sphere huge = new Sphere("sphere", new Vector3d(0, 0, 10), 1e200, ColouredSurface.DEFAULT);
        WindowDriver.onEventThread(() -> {
            dialog().dispose();
            model.set(Studios.sphere().withScene(List.of(huge)));
            QualityChart.open(model, frame);
        });
        WindowDriver.await("the message", () -> state().contains("scene[0]"));
    }

    /** Gives the mouse to a place some pixels to the right of a point. */
    private static void mouse(StudyPoint point, int right) {
        ChartPanel chart = Components.find(dialog().getContentPane(), ChartPanel.class, "chart");
        chart.paintImmediately(0, 0, chart.getWidth(), chart.getHeight());
        XYPlot plot = chart.getChart().getXYPlot();
        Rectangle2D area = chart.getScreenDataArea();
        double x = plot.getDomainAxis().valueToJava2D(point.seconds().middle(), area, plot.getDomainAxisEdge());
        double y = plot.getRangeAxis().valueToJava2D(point.error().middle(), area, plot.getRangeAxisEdge());
        chart.dispatchEvent(new MouseEvent(chart, MouseEvent.MOUSE_CLICKED, 0, 0, (int) x + right, (int) y, 1, false));
    }

    private static JDialog dialog() {
        return Stream.of(Window.getWindows())
                .filter(window -> "quality".equals(window.getName()) && window.isVisible())
                .map(JDialog.class::cast)
                .findFirst()
                .orElseThrow();
    }

    private static String state() {
        return Components.find(dialog().getContentPane(), JTextArea.class, "state")
                .getText();
    }
}
