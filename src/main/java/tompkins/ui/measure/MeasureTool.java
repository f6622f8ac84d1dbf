package tompkins.ui.measure;

import java.awt.Cursor;
import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import javax.swing.JComponent;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import tompkins.measure.MeasureKind;
import tompkins.measure.Measured;
import tompkins.measure.Measurements;
import tompkins.measure.Sketch;
import tompkins.trace.RenderPlan;
import tompkins.ui.photograph.PhotographView;
import tompkins.ui.picture.Picture;
import tompkins.ui.picture.PictureTool;
import tompkins.ui.widget.Texts;

/**
 * Measures in the photograph: while it is on, clicks mark places, and a panel under the picture says what lies between
 * them. If another picture is compared, clicks there mark places in that one, and sizes in both are compared, too. It
 * measures again in each new picture. One place more than needed starts again.
 */
public final class MeasureTool implements PictureTool {

    private final PhotographView view;
    private final Consumer<String> copier;
    private final Ruler ruler;
    private final Ruler otherRuler;
    private final MeasureMarks marks;

    /** Null until it is first wanted. */
    private MeasurePanel panel;

    /**
     * What came of measuring.
     *
     * @param measured what was measured, in pixels of the photograph in its own size; null if that is impossible
     * @param problem why not; empty if it was measured
     */
    record Answer(Measured measured, String problem) {

        /** Measures between places of a picture, in pixels of its photograph, as long as that is wanted. */
        static Answer of(Picture picture, MeasureKind kind, List<Vector2dc> places, BooleanSupplier wanted) {
            // places are those of the photograph in its own size
            RenderPlan plan = RenderPlan.of(picture.studio(), picture.plan());
            try {
                return new Answer(Measurements.measure(plan, kind, places, wanted), "");
            } catch (ArithmeticException noFit) {
                return new Answer(null, noFit.getMessage());
            }
        }
    }

    /** The places in one of two pictures, and what lies between them. */
    private final class Ruler {

        private final List<Vector2dc> places = new ArrayList<>();
        private Answer answer;

        void add(Point2D place) {
            if (places.size() == panel.kind().most()) {
                places.clear();
            }
            places.add(new Vector2d(place.getX(), place.getY()));
        }

        /** Measures in a picture, or in none if that is null. */
        void measure(Picture picture) {
            places.removeIf(place -> picture == null || !picture.holds(new Point2D.Double(place.x(), place.y())));
            if (places.size() < panel.kind().fewest()) {
                view.asker().drop(this);
                answer = null;
            } else {
                MeasureKind kind = panel.kind();
                List<Vector2dc> asked = List.copyOf(places);
                view.asker().ask(this, wanted -> Answer.of(picture, kind, asked, wanted), found -> {
                    answer = found;
                    tell();
                });
            }
        }

        List<MeasureMarks.Marked> marked() {
            Measured measured = answer == null ? null : answer.measured();
            List<Vector2dc> points = List.copyOf(places);
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
        view.addTool(this);
    }

    @Override
    public boolean isWanted() {
        return panel != null && panel.component().isVisible();
    }

    @Override
    public String hint() {
        return Texts.get("status.idle.MEASURE");
    }

    @Override
    public int cursor() {
        return Cursor.CROSSHAIR_CURSOR;
    }

    @Override
    public void click(Point2D place, Picture seen) {
        add(view.canvas().shown().placeIn(seen, place), seen);
    }

    /** Two points to measure between may be as close as that. */
    @Override
    public boolean clickAgain(Point2D place, Picture seen) {
        click(place, seen);
        return true;
    }

    /** What says what lies between the places; made when it is first asked for. */
    public JComponent component() {
        if (panel == null) {
            panel = new MeasurePanel(this, copier);
        }
        return panel.component();
    }

    /** Measures from now on, or ends that; {@link #component} was asked for before. */
    public void setOn(boolean on) {
        panel.component().setVisible(on);
        view.tellTool();
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
        if (isWanted()) {
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
}
