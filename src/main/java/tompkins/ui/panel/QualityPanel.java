package tompkins.ui.panel;

import com.formdev.flatlaf.FlatLaf;
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
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.swing.BorderFactory;
import javax.swing.JDialog;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import javax.swing.WindowConstants;
import org.jfree.chart.ChartMouseEvent;
import org.jfree.chart.ChartMouseListener;
import org.jfree.chart.ChartPanel;
import tompkins.render.Quality;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;
import tompkins.study.ChartDrawing;
import tompkins.study.ChartStyle;
import tompkins.study.PictureStudy;
import tompkins.study.StudyPoint;
import tompkins.ui.model.StudioModel;
import tompkins.ui.widget.Buttons;
import tompkins.ui.widget.Keys;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.Messages;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.NumberField;
import tompkins.ui.widget.NumberKind;
import tompkins.ui.widget.Numbers;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Screens;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.Wording;

/** How good the picture has to be: the target error, and a chart of speed against accuracy to choose from. */
public final class QualityPanel extends Part {

    /** The size of the chart at first, in sizes of the type. */
    private static final double CHART_WIDTH = 66;

    private static final double CHART_HEIGHT = 40;

    /** How far from a point the mouse still selects it, in pixels. */
    private static final double REACH = 12;

    private final Note asked = Note.ofLines(2);
    private final NumberField error;
    private final StudioModel model;
    private final BiConsumer<PictureStudy, Consumer<List<StudyPoint>>> measuring;
    private Quality shown;

    /** The window that is open, which replaces the previous one; null if none is. */
    private ChartWindow chartWindow;

    /** The panel. */
    public QualityPanel(StudioModel model) {
        this(model, PictureStudy::measure);
    }

    /** The panel, with another way to the points of the chart. */
    QualityPanel(StudioModel model, BiConsumer<PictureStudy, Consumer<List<StudyPoint>>> measuring) {
        super(Rows.panel());
        this.model = model;
        this.measuring = measuring;
        String title = Wording.label("targetError");
        String meaning = Wording.meaning(RenderSettings.class, "targetError");
        error = new NumberField(
                NumberKind.DOUBLE, "targetError", title, meaning, asked, value -> want(value.doubleValue()));
        Rows.add(panel, title, error.field(), "skip");
        panel.add(asked.component(), "span, growx, wmin 0");
        panel.add(Buttons.of("quality.measure", this::chart), "span 3, growx");
        model.follow(this::update);
    }

    private void chart() {
        if (chartWindow != null) {
            chartWindow.dialog.dispose();
        }
        chartWindow = new ChartWindow(SwingUtilities.getWindowAncestor(panel));
        chartWindow.start();
    }

    private void want(double targetError) {
        Studio studio = model.studio();
        model.set(studio.withSettings(studio.settings().withTargetError(targetError)));
    }

    /** Takes a quality of the chart into the scene. */
    private void take(Quality quality) {
        if (quality instanceof Quality.TargetError target) {
            want(target.rootMeanSquare());
        } else if (quality instanceof Quality.Samples fixed) {
            Studio studio = model.studio();
            model.set(studio.withSettings(studio.settings().withSamples(fixed.samples())));
        }
    }

    private void update() {
        error.show(model.studio().settings().targetError());
        Quality now = Quality.of(model.studio());
        if (!now.equals(shown)) {
            shown = now;
            asked.setUsual(text(now));
            if (chartWindow != null) {
                chartWindow.forgetPoint();
            }
        }
    }

    private static String text(Quality quality) {
        if (quality instanceof Quality.TargetError target) {
            return Texts.get("quality.error", Numbers.brief(target.rootMeanSquare(), 2));
        }
        return quality instanceof Quality.Samples fixed && fixed.samples() > 1
                ? Texts.get("quality.samples", fixed.samples())
                : Texts.get("quality.sample");
    }

    /** A window with the chart of the picture on show, which grows while it is measured. */
    private final class ChartWindow {

        private final JDialog dialog;
        private final ChartPanel chart = new StyledChartPanel();
        private final Note state = Note.ofLines(2);
        private volatile boolean closed;
        private final Studio studio = model.studio();

        /** Null until its scene has been prepared. */
        private PictureStudy study;

        private List<StudyPoint> shown = List.of();

        /** What is said about the point under the mouse, which a click would take; null if there is none. */
        private String pointedAt;

        /** What is said about the point that was taken; null if none is in force. */
        private String chosenPoint;

        /** What is said after the measuring has ended; null before. */
        private String ended;

        ChartWindow(Window owner) {
            dialog = new JDialog(owner, Texts.get("section.quality"));
            dialog.setName("quality");
            state.component().setName("state");
            chart.setName("chart");
            dialog.setDefaultCloseOperation(WindowConstants.DISPOSE_ON_CLOSE);
            Keys.bindEscape(dialog.getRootPane(), dialog::dispose);
            dialog.addWindowListener(new WindowAdapter() {
                @Override
                public void windowClosed(WindowEvent event) {
                    closed = true;
                    if (chartWindow == ChartWindow.this) {
                        // it holds the prepared scene, which may be large
                        chartWindow = null;
                    }
                }
            });
            chart.setPreferredSize(new Dimension(Look.pixels(CHART_WIDTH), Look.pixels(CHART_HEIGHT)));
            // its own menu saves without asking whether to overwrite, and a drag would zoom away from the points
            chart.setPopupMenu(null);
            chart.setMouseZoomable(false);
            // otherwise it would be drawn smaller and stretched if there is more room
            chart.setMaximumDrawWidth(Integer.MAX_VALUE);
            chart.setMaximumDrawHeight(Integer.MAX_VALUE);
            PointChooser chooser = new PointChooser();
            chart.addChartMouseListener(chooser);
            chart.addMouseListener(chooser);
            JPanel content = new JPanel(new BorderLayout());
            content.add(chart, BorderLayout.CENTER);
            JPanel below = new JPanel(new BorderLayout());
            below.setBorder(BorderFactory.createEmptyBorder(6, 10, 6, 10));
            below.add(state.component());
            content.add(below, BorderLayout.SOUTH);
            dialog.setContentPane(content);
            dialog.pack();
            dialog.setLocationRelativeTo(owner);
            Screens.keepOnScreen(dialog);
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
                PictureStudy made = new PictureStudy(studio, () -> closed);
                SwingUtilities.invokeLater(() -> study = made);
                measuring.accept(made, measured -> SwingUtilities.invokeLater(() -> draw(measured)));
                SwingUtilities.invokeLater(
                        () -> end(Texts.get(made.chart().drawn(shown).isEmpty() ? "quality.exact" : "quality.choose")));
            } catch (CancellationException stopped) {
                // the window was closed
            } catch (RuntimeException | OutOfMemoryError | StackOverflowError error) {
                SwingUtilities.invokeLater(() -> end(Messages.of(error)));
            }
        }

        private void end(String text) {
            ended = text;
            showState();
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

        private void draw(List<StudyPoint> measured) {
            shown = measured;
            draw();
            showState();
        }

        private void draw() {
            ChartStyle style = FlatLaf.isLafDark() ? ChartStyle.DARK : ChartStyle.PRINTED;
            chart.setChart(ChartDrawing.drawing(study.chart(), shown, style.withSize(Look.pixels(1))));
        }

        private String progress() {
            String measuring = Texts.get("quality.measuring");
            return shown.isEmpty()
                    ? measuring
                    : String.format(Locale.ROOT, "%s  %d / %d", measuring, shown.size(), study.points());
        }

        /** The point nearest to the mouse; null if none is near. */
        private StudyPoint near(ChartMouseEvent event) {
            return ChartDrawing.nearest(
                    study.chart(),
                    shown,
                    event.getChart().getXYPlot(),
                    chart.getScreenDataArea(),
                    event.getTrigger().getPoint(),
                    REACH);
        }

        private void pointAt(StudyPoint point) {
            pointedAt = point == null ? null : Texts.get("quality.pointedAt", text(study.qualityOf(point)));
            chart.setCursor(Cursor.getPredefinedCursor(point == null ? Cursor.DEFAULT_CURSOR : Cursor.HAND_CURSOR));
            showState();
        }

        /** A chart that follows the look. */
        @SuppressWarnings("serial") // never written to a stream
        private final class StyledChartPanel extends ChartPanel {

            StyledChartPanel() {
                super(null);
            }

            @Override
            public void updateUI() {
                super.updateUI();
                if (study != null) {
                    draw();
                }
            }
        }

        private final class PointChooser extends MouseAdapter implements ChartMouseListener {

            @Override
            public void chartMouseClicked(ChartMouseEvent event) {
                StudyPoint point = near(event);
                if (point != null) {
                    take(study.qualityOf(point));
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
