package tompkins.ui.panel;

import com.formdev.flatlaf.FlatLaf;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
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
import tompkins.ui.widget.Keys;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.Messages;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Screens;
import tompkins.ui.widget.Texts;

/**
 * A dialog with the speed and the accuracy of the picture on show, which grows while it is measured; a click takes a
 * point.
 */
public final class QualityChart implements ChartMouseListener {

    /** How far from a point the mouse still selects it, in pixels. */
    private static final double REACH = 12;

    private final StudioModel model;
    private final Studio studio;
    private final JDialog dialog;
    private final ChartPanel chart = new ChartPanel(null);
    private final Note state = Note.ofLines(2);
    private PictureStudy study;
    private List<StudyPoint> points = List.of();
    private volatile boolean closed;

    private QualityChart(StudioModel model, JFrame owner) {
        this.model = model;
        studio = model.studio();
        dialog = new JDialog(owner, Texts.get("quality.title"));
        dialog.setName("quality");
        chart.setName("chart");
        state.component().setName("state");
        chart.setPreferredSize(new Dimension(Look.pixels(66), Look.pixels(40)));
        // its own menu saves without asking whether to overwrite, and a drag would zoom away from the points
        chart.setPopupMenu(null);
        chart.setMouseZoomable(false);
        chart.addChartMouseListener(this);
        dialog.add(chart, BorderLayout.CENTER);
        dialog.add(state.component(), BorderLayout.SOUTH);
        Keys.bindEscape(dialog.getRootPane(), dialog::dispose);
        dialog.setDefaultCloseOperation(JDialog.DISPOSE_ON_CLOSE);
        dialog.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosed(WindowEvent event) {
                closed = true;
            }
        });
        dialog.pack();
        dialog.setLocationRelativeTo(owner);
        Screens.keepOnScreen(dialog);
    }

    /** Opens it over a window, and begins to measure the picture of a model. */
    public static void open(StudioModel model, JFrame owner) {
        open(model, owner, PictureStudy::measure);
    }

    /** The same, with another way to the points. */
    static void open(StudioModel model, JFrame owner, BiConsumer<PictureStudy, Consumer<List<StudyPoint>>> measuring) {
        QualityChart made = new QualityChart(model, owner);
        made.state.setText(Texts.get("quality.measuring"));
        made.dialog.setVisible(true);
        Thread thread = new Thread(() -> made.measure(measuring), "tompkins-study");
        thread.setDaemon(true);
        thread.setPriority(Thread.MIN_PRIORITY);
        thread.start();
    }

    private void measure(BiConsumer<PictureStudy, Consumer<List<StudyPoint>>> measuring) {
        try {
            PictureStudy made = new PictureStudy(studio, () -> closed);
            measuring.accept(made, measured -> SwingUtilities.invokeLater(() -> draw(made, measured)));
            SwingUtilities.invokeLater(
                    () -> state.setText(Texts.get(points.isEmpty() ? "quality.exact" : "quality.choose")));
        } catch (CancellationException stopped) {
            // the dialog was closed
        } catch (RuntimeException | OutOfMemoryError | StackOverflowError error) {
            SwingUtilities.invokeLater(() -> state.setError(Messages.of(error)));
        }
    }

    private void draw(PictureStudy made, List<StudyPoint> measured) {
        study = made;
        points = measured;
        ChartStyle style = FlatLaf.isLafDark() ? ChartStyle.DARK : ChartStyle.PRINTED;
        chart.setChart(ChartDrawing.drawing(study.chart(), points, style.withSize(Look.pixels(1))));
    }

    @Override
    public void chartMouseClicked(ChartMouseEvent event) {
        StudyPoint point = ChartDrawing.nearest(
                study.chart(),
                points,
                event.getChart().getXYPlot(),
                chart.getScreenDataArea(),
                event.getTrigger().getPoint(),
                REACH);
        if (point != null) {
            RenderSettings now = model.studio().settings();
            Quality taken = study.qualityOf(point);
            RenderSettings next = taken instanceof Quality.TargetError target
                    ? now.withTargetError(target.rootMeanSquare())
                    : now.withSamples(((Quality.Samples) taken).samples());
            model.set(model.studio().withSettings(next));
            state.setText(Texts.get("quality.chosen"));
        }
    }

    @Override
    public void chartMouseMoved(ChartMouseEvent event) {}
}
