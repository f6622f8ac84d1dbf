package tompkins.ui.measure;

import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import javax.swing.JComponent;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import tompkins.measure.MeasureKind;
import tompkins.measure.Measured;
import tompkins.measure.Sketch;
import tompkins.ui.photograph.PhotographView;
import tompkins.ui.picture.Picture;

/**
 * Measures in the photograph: while it is on, clicks mark places, and a panel under the picture says what lies between
 * them. If another picture is compared, clicks there mark places in that one, and sizes in both are compared, too. It
 * measures again in each new picture. One place more than needed starts again.
 */
public final class MeasureTool {

    private final PhotographView view;
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

        List<MeasureMarks.Marked> marked() {
            Measured measured = answer == null ? null : answer.measured();
            List<Vector2dc> points = new ArrayList<>();
            places.forEach(place -> points.add(new Vector2d(place.getX(), place.getY())));
            Sketch sketch = new Sketch(points, measured == null ? List.of() : measured.lines());
            return points.isEmpty()
                    ? List.of()
                    : List.of(new MeasureMarks.Marked(
                            sketch,
                            IntStream.rangeClosed(1, points.size())
                                    .mapToObj(Integer::toString)
                                    .toList()));
        }

        void forget() {
            places.clear();
            answer = null;
        }
    }

    /**
     * A tool that is off.
     *
     * @param copier puts a text on the clipboard
     */
    public MeasureTool(PhotographView view, Consumer<String> copier) {
        this.view = view;
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

    /** What says what lies between the places; made when it is first asked for. */
    public JComponent component() {
        if (panel == null) {
            panel = new MeasurePanel(this);
        }
        return panel.component();
    }

    /** Measures from now on, or ends that; {@link #component} was asked for before. */
    public void setOn(boolean on) {
        panel.component().setVisible(on);
        view.setMeasuring(on ? this::add : null);
        if (on) {
            update();
        } else {
            clear();
        }
    }

    /** Begins anew with a place of a picture, while it measures. */
    public void begin(Point2D place, Picture picture) {
        clear();
        add(place, picture);
    }

    private void add(Point2D place, Picture picture) {
        (picture == view.otherPicture() ? otherRuler : ruler).add(place);
        update();
    }

    /** Other pictures are on the screen: measures in them what was measured in the previous ones. */
    public void show() {
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

    /** Measures something else. */
    void choose(MeasureKind kind) {
        for (Ruler each : List.of(ruler, otherRuler)) {
            each.answer = null;
            while (each.places.size() > kind.most()) {
                each.places.remove(each.places.size() - 1);
            }
        }
        update();
    }

    /** Forgets all places. */
    void clear() {
        ruler.forget();
        otherRuler.forget();
        update();
    }

    /** Puts a text on the clipboard. */
    void copy(String text) {
        copier.accept(text);
    }

    /** Ends the work for good. */
    public void dispose() {
        ruler.probe.close();
        otherRuler.probe.close();
    }
}
