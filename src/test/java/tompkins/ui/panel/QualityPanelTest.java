package tompkins.ui.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Window;
import java.awt.event.MouseEvent;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.JTextArea;
import org.jfree.chart.ChartPanel;
import org.jfree.chart.plot.XYPlot;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import tompkins.studio.Studios;
import tompkins.study.Spread;
import tompkins.study.StudyPoint;
import tompkins.ui.Components;
import tompkins.ui.NeedsDisplay;
import tompkins.ui.WindowDriver;
import tompkins.ui.model.StudioModel;
import tompkins.ui.widget.Look;

/** A click on a point of the chart, whose points have times and errors that were never measured. */
@Timeout(600)
@NeedsDisplay
class QualityPanelTest {

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
            frame.add(new QualityPanel(model, (study, listener) -> listener.accept(POINTS)).component());
            frame.pack();
            Components.find(frame, JButton.class, "Chart this picture").doClick();
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
            choose(SAME, "4 samples per pixel");
            assertThat(model.studio().settings().samples()).isEqualTo(4);

            choose(NEEDED, "Samples where they are needed, error 0.001");
            assertThat(model.studio().settings().targetError()).isEqualTo(0.001);
        });
    }

    @Test
    void aPointIsForgottenWhenTheSceneHasAnotherNumber() {
        WindowDriver.onEventThread(() -> {
            choose(SAME, "4 samples per pixel");
            model.set(model.studio().withSettings(model.studio().settings().withSamples(3)));
            assertThat(state()).startsWith("Click a point");
        });
    }

    @Test
    void besideThePointsNothingIsTaken() {
        WindowDriver.onEventThread(() -> {
            mouse(MouseEvent.MOUSE_MOVED, SAME, 40);
            mouse(MouseEvent.MOUSE_CLICKED, SAME, 40);
            assertThat(state()).startsWith("Click a point");
            assertThat(model.studio().settings().samples()).isEqualTo(1);
        });
    }

    private static void choose(StudyPoint point, String quality) {
        mouse(MouseEvent.MOUSE_MOVED, point, 0);
        assertThat(state()).isEqualTo("Click to use: " + quality);
        mouse(MouseEvent.MOUSE_CLICKED, point, 0);
        assertThat(state()).isEqualTo("Chosen for the picture: " + quality);
    }

    /** Gives the mouse to a place some pixels to the right of a point. */
    private static void mouse(int id, StudyPoint point, int right) {
        ChartPanel chart = Components.find(dialog().getContentPane(), ChartPanel.class, "chart");
        chart.paintImmediately(0, 0, chart.getWidth(), chart.getHeight());
        XYPlot plot = chart.getChart().getXYPlot();
        Rectangle2D area = chart.getScreenDataArea();
        double x = plot.getDomainAxis().valueToJava2D(point.seconds().middle(), area, plot.getDomainAxisEdge());
        double y = plot.getRangeAxis().valueToJava2D(point.error().middle(), area, plot.getRangeAxisEdge());
        chart.dispatchEvent(new MouseEvent(chart, id, 0, 0, (int) x + right, (int) y, 1, false));
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
