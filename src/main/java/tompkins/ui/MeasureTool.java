package tompkins.ui;

import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JPanel;
import tompkins.measure.MeasureKind;
import tompkins.ui.panel.MeasurePanel;
import tompkins.ui.picture.MeasureMarks;
import tompkins.ui.picture.MeasureProbe;
import tompkins.ui.picture.Picture;

/**
 * Measures in the photograph: while it is on, clicks mark places, and a panel under the picture says what lies between
 * them. It measures again in each new picture. One place more than needed starts again.
 */
final class MeasureTool implements MeasurePanel.Commands {

    private final PhotographView view;
    private final JPanel bars;
    private final Consumer<String> copier;
    private final MeasureProbe probe;
    private final MeasureMarks marks = new MeasureMarks();
    private final List<Point2D> places = new ArrayList<>();

    /** Null until it is first wanted. */
    private MeasurePanel panel;

    /**
     * A tool that is off.
     *
     * @param bars where its panel goes
     * @param copier puts a text on the clipboard
     */
    MeasureTool(PhotographView view, JPanel bars, Consumer<String> copier) {
        this.view = view;
        this.bars = bars;
        this.copier = copier;
        probe = new MeasureProbe(view::fail);
        view.canvas().addOverlay(marks);
    }

    /** Whether clicks mark places. */
    boolean isOn() {
        return panel != null && panel.component().isVisible();
    }

    /** Begins to measure, or ends it. */
    void toggle() {
        if (isOn()) {
            close(false);
        } else {
            open();
        }
    }

    /** Ends the measuring; false if there was none. */
    boolean end() {
        boolean was = isOn();
        close(false);
        return was;
    }

    private void open() {
        if (panel == null) {
            panel = new MeasurePanel(this);
            bars.add(panel.component());
        }
        panel.component().setVisible(true);
        view.setMeasuring(this::add);
        update();
        bars.revalidate();
    }

    private void close(boolean forGood) {
        if (panel != null) {
            panel.component().setVisible(false);
            view.setMeasuring(null);
            clear();
        }
        if (forGood) {
            probe.close();
        }
    }

    private void add(Point2D place) {
        if (places.size() == panel.kind().most()) {
            places.clear();
        }
        places.add(place);
        update();
    }

    /** Another picture is on the screen: measures in it what was measured in the previous one. */
    void show(Picture picture) {
        if (isOn()) {
            places.removeIf(place -> !picture.holds(place));
            update();
        }
    }

    private void update() {
        Picture picture = view.canvas().shown().now();
        MeasureKind kind = panel.kind();
        if (picture == null || places.size() < kind.fewest()) {
            probe.forget();
            panel.show(null);
            marks.show(places, List.of());
        } else {
            List<Point2D> asked = List.copyOf(places);
            probe.ask(picture, kind, asked, answer -> {
                panel.show(answer);
                marks.show(
                        asked,
                        answer.measured() == null
                                ? List.of()
                                : answer.measured().lines());
                view.canvas().repaint();
            });
            marks.show(places, List.of());
        }
        view.canvas().repaint();
    }

    @Override
    public void choose(MeasureKind kind) {
        while (places.size() > kind.most()) {
            places.remove(places.size() - 1);
        }
        update();
    }

    @Override
    public void clear() {
        places.clear();
        update();
    }

    @Override
    public void copy(String text) {
        copier.accept(text);
    }

    /** Ends the measuring, as the panel asks. */
    @Override
    public void close() {
        close(false);
    }

    /** Ends the work for good. */
    void dispose() {
        close(true);
    }
}
