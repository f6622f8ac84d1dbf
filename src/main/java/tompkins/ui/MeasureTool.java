package tompkins.ui;

import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JPanel;
import tompkins.measure.MeasureKind;
import tompkins.measure.Measured;
import tompkins.ui.panel.MeasurePanel;
import tompkins.ui.picture.MeasureMarks;
import tompkins.ui.picture.MeasureProbe;
import tompkins.ui.picture.Picture;

/**
 * Measures in the photograph: while it is on, clicks mark places, and a panel under the picture says what lies between
 * them. If another picture is compared, clicks there mark places in that one, and sizes in both are compared, too. It
 * measures again in each new picture. One place more than needed starts again.
 */
final class MeasureTool implements MeasurePanel.Commands {

    private final PhotographView view;
    private final JPanel bars;
    private final Consumer<String> copier;
    private final Ruler ruler;
    private final Ruler otherRuler;
    private final MeasureMarks marks;

    /** Null until it is first wanted. */
    private MeasurePanel panel;

    /** The places in one of two pictures, and what lies between them. */
    private final class Ruler {

        private final MeasureProbe probe = new MeasureProbe(view::fail);
        private final List<Point2D> places = new ArrayList<>();
        private MeasureProbe.Answer answer;

        void add(Point2D place) {
            if (places.size() == panel.kind().most()) {
                places.clear();
            }
            places.add(place);
        }

        /** Measures in a picture, or in none if that is null. */
        void measure(Picture picture) {
            places.removeIf(place -> picture == null || !picture.holds(place));
            if (places.size() < panel.kind().fewest()) {
                probe.forget();
                answer = null;
            } else {
                probe.ask(picture, panel.kind(), places, found -> {
                    answer = found;
                    tell();
                });
            }
        }

        MeasureMarks.Marked marked() {
            Measured measured = answer == null ? null : answer.measured();
            return new MeasureMarks.Marked(places, measured == null ? List.of() : measured.lines());
        }

        void forget() {
            places.clear();
            answer = null;
        }
    }

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
        ruler = new Ruler();
        otherRuler = new Ruler();
        marks = new MeasureMarks(view::otherPicture);
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
        view.setMeasuring((place, picture) -> {
            (picture == view.otherPicture() ? otherRuler : ruler).add(place);
            update();
        });
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
            ruler.probe.close();
            otherRuler.probe.close();
        }
    }

    /** Other pictures are on the screen: measures in them what was measured in the previous ones. */
    void show() {
        if (isOn()) {
            update();
        }
    }

    private void update() {
        ruler.measure(view.canvas().shown().now());
        otherRuler.measure(view.otherPicture());
        tell();
    }

    private void tell() {
        panel.show(ruler.answer, otherRuler.answer, view.otherPicture() == null ? null : view.otherName());
        marks.show(ruler.marked(), otherRuler.marked());
        view.canvas().repaint();
    }

    @Override
    public void choose(MeasureKind kind) {
        for (Ruler each : List.of(ruler, otherRuler)) {
            each.answer = null;
            while (each.places.size() > kind.most()) {
                each.places.remove(each.places.size() - 1);
            }
        }
        update();
    }

    @Override
    public void clear() {
        ruler.forget();
        otherRuler.forget();
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
