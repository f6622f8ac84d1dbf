package tompkins.ui.panel;

import java.awt.BorderLayout;
import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Window;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.concurrent.CancellationException;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import javax.swing.WindowConstants;
import org.jfree.chart.ChartMouseEvent;
import org.jfree.chart.ChartMouseListener;
import org.jfree.chart.ChartPanel;
import tompkins.render.Quality;
import tompkins.studio.Studio;
import tompkins.study.ChartDrawing;
import tompkins.study.Measurement;
import tompkins.study.PictureStudy;
import tompkins.ui.model.StudioModel;
import tompkins.ui.widget.Keys;
import tompkins.ui.widget.Messages;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Numbers;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;

/** How good the picture has to be: as its scene says, or the point that is chosen on a chart of speed against accuracy. */
public final class QualityPanel {

    private static final int CHART_WIDTH = 860;
    private static final int CHART_HEIGHT = 520;

    /** How far from a point the mouse still takes it, in pixels. */
    private static final double REACH = 12;

    private final JPanel panel = Rows.column();
    private final Note chosen = new Note("");
    private final JButton asScene = new JButton(Texts.get("quality.asScene"));
    private final JButton measure = new JButton(Texts.get("quality.measure"));
    private final StudioModel model;
    private final Consumer<Quality> choose;
    private Studio opened;
    private int sceneSamples;

    /** The last one that was opened; null before. */
    private ChartWindow chartWindow;

    /**
     * The panel.
     *
     * @param choose told of the quality that was chosen; null for what the scene says
     */
    public QualityPanel(StudioModel model, Consumer<Quality> choose) {
        this.model = model;
        this.choose = choose;
        asScene.setName(Texts.get("quality.asScene"));
        asScene.addActionListener(event -> set(null));
        Naming.name(measure, Texts.get("quality.measure"), Texts.get("quality.measureTip"));
        measure.addActionListener(event -> {
            chartWindow = new ChartWindow(SwingUtilities.getWindowAncestor(panel));
            chartWindow.start();
        });
        panel.add(chosen.component(), "wmin 0");
        panel.add(asScene, "wmin 0");
        panel.add(measure, "wmin 0");
        show(null);
        model.addListener(this::update);
        update();
    }

    /** The panel itself. */
    public JComponent component() {
        return panel;
    }

    /** Takes a quality: a number of samples goes into the scene, an error stays with the window; null is what the scene says. */
    void set(Quality quality) {
        forgetPoint();
        if (quality instanceof Quality.Samples fixed) {
            Studio studio = model.studio();
            show(null);
            choose.accept(null);
            model.set(studio.withSettings(studio.settings().withSamples(fixed.samples())));
        } else {
            show(quality);
            choose.accept(quality);
        }
    }

    /** Whoever changes the number of samples of the scene wants to see that number. */
    private void update() {
        int samples = model.studio().settings().samples();
        boolean changed = model.opened() == opened && samples != sceneSamples;
        opened = model.opened();
        sceneSamples = samples;
        if (changed && asScene.isEnabled()) {
            set(null);
        } else if (changed) {
            forgetPoint();
        }
    }

    /** No point of the chart is in force any more. */
    private void forgetPoint() {
        if (chartWindow != null) {
            chartWindow.forgetPoint();
        }
    }

    private void show(Quality quality) {
        chosen.setText(text(quality));
        asScene.setEnabled(quality != null);
    }

    private static String text(Quality quality) {
        if (quality instanceof Quality.TargetError target) {
            return Texts.get("quality.error", Numbers.brief(target.rootMeanSquare(), 2));
        }
        return quality instanceof Quality.Samples fixed && fixed.samples() > 1
                ? Texts.get("quality.samples", fixed.samples())
                : Texts.get(quality == null ? "quality.scene" : "quality.sample");
    }

    /** A window with the chart of the picture on show, which grows while it is measured. */
    private final class ChartWindow {

        private final JDialog dialog;
        private final PictureStudy study = new PictureStudy(model.studio());
        private final ChartPanel chart = new ChartPanel(null);
        private final JLabel state = new JLabel();
        private volatile boolean closed;
        private List<Measurement> shown = List.of();

        /** What is said of the point under the mouse, which a click would take; null if there is none. */
        private String pointedAt;

        /** What is said of the point that was taken; null if none is in force. */
        private String chosenPoint;

        /** What is said once nothing is measured any more; null before. */
        private String ended;

        ChartWindow(Window owner) {
            dialog = new JDialog(owner, Texts.get("section.quality"));
            dialog.setName("quality");
            state.setName("state");
            chart.setName("chart");
            dialog.setDefaultCloseOperation(WindowConstants.DISPOSE_ON_CLOSE);
            Keys.bindEscape(dialog.getRootPane(), dialog::dispose);
            dialog.addWindowListener(new WindowAdapter() {
                @Override
                public void windowClosed(WindowEvent event) {
                    closed = true;
                }
            });
            chart.setPreferredSize(new Dimension(CHART_WIDTH, CHART_HEIGHT));
            PointChooser chooser = new PointChooser();
            chart.addChartMouseListener(chooser);
            chart.addMouseListener(chooser);
            JPanel content = new JPanel(new BorderLayout());
            content.add(chart, BorderLayout.CENTER);
            state.setBorder(BorderFactory.createEmptyBorder(6, 10, 6, 10));
            content.add(state, BorderLayout.SOUTH);
            dialog.setContentPane(content);
            dialog.pack();
            dialog.setLocationRelativeTo(owner);
        }

        void start() {
            showState();
            dialog.setVisible(true);
            Thread thread = new Thread(this::measure, "tompkins-study");
            thread.setDaemon(true);
            thread.setPriority(Thread.MIN_PRIORITY);
            thread.start();
        }

        private void measure() {
            try {
                study.measure(measured -> SwingUtilities.invokeLater(() -> draw(measured)), () -> closed);
                end(Texts.get("quality.choose"));
            } catch (CancellationException stopped) {
                // the window was closed
            } catch (RuntimeException | OutOfMemoryError | StackOverflowError error) {
                end(Messages.of(error));
            }
        }

        private void end(String text) {
            SwingUtilities.invokeLater(() -> {
                ended = text;
                showState();
            });
        }

        private void forgetPoint() {
            chosenPoint = null;
            showState();
        }

        private void showState() {
            state.setText(Stream.of(pointedAt, chosenPoint, ended)
                    .filter(Objects::nonNull)
                    .findFirst()
                    .orElseGet(this::progress));
        }

        private void draw(List<Measurement> measured) {
            shown = measured;
            chart.setChart(ChartDrawing.drawing(study.chart(), measured));
            showState();
        }

        private String progress() {
            return String.format(
                    Locale.ROOT, "%s  %d / %d", Texts.get("quality.measuring"), shown.size(), study.points());
        }

        /** The point nearest to the mouse; null if none is near. */
        private Measurement near(ChartMouseEvent event) {
            return ChartDrawing.nearest(
                    study.chart(),
                    shown,
                    event.getChart().getXYPlot(),
                    chart.getScreenDataArea(),
                    event.getTrigger().getPoint(),
                    REACH);
        }

        private void pointAt(Measurement point) {
            pointedAt = point == null ? null : Texts.get("quality.pointedAt", text(study.qualityOf(point)));
            chart.setCursor(Cursor.getPredefinedCursor(point == null ? Cursor.DEFAULT_CURSOR : Cursor.HAND_CURSOR));
            showState();
        }

        private final class PointChooser extends MouseAdapter implements ChartMouseListener {

            @Override
            public void chartMouseClicked(ChartMouseEvent event) {
                Measurement point = near(event);
                if (point != null) {
                    set(study.qualityOf(point));
                    chosenPoint = Texts.get("quality.chosen", text(study.qualityOf(point)));
                    pointedAt = null;
                    showState();
                }
            }

            @Override
            public void chartMouseMoved(ChartMouseEvent event) {
                pointAt(near(event));
            }

            @Override
            public void mouseExited(MouseEvent event) {
                pointAt(null);
            }
        }
    }
}
