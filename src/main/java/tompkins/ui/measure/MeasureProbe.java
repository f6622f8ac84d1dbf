package tompkins.ui.measure;

import java.awt.geom.Point2D;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import tompkins.measure.MeasureKind;
import tompkins.measure.Measured;
import tompkins.measure.Measurements;
import tompkins.measure.Profile;
import tompkins.trace.RenderPlan;
import tompkins.ui.picture.NewestFirst;
import tompkins.ui.picture.Picture;

/** Measures between places of the photograph, on a thread of its own; a newer question ends the previous one. */
public final class MeasureProbe implements AutoCloseable {

    /**
     * The answer to a question.
     *
     * @param measured what was measured, in pixels of the photograph in its own size; null if that is impossible
     * @param problem why not; empty if it was measured
     */
    public record Answer(Measured measured, String problem) {}

    private final NewestFirst worker;

    /** The question at hand; null if there is none. */
    private volatile Object newest;

    /** A probe; its thread tells {@code failures} about questions that could not be answered. */
    public MeasureProbe(Consumer<Throwable> failures) {
        worker = new NewestFirst("tompkins-measure", failures);
    }

    /**
     * Measures between places of a picture, in pixels of its photograph; the answer comes on the event thread, unless a
     * newer question comes first.
     */
    public void ask(Picture picture, MeasureKind kind, List<Point2D> places, Consumer<Answer> answer) {
        Object question = new Object();
        newest = question;
        BooleanSupplier wanted = () -> newest == question;
        List<Point2D> asked = List.copyOf(places);
        worker.ask(() -> measure(picture, kind, asked, wanted), found -> {
            if (wanted.getAsBoolean()) {
                answer.accept(found);
            }
        });
    }

    /** Drops the question at hand. */
    public void forget() {
        newest = null;
    }

    private static Answer measure(Picture picture, MeasureKind kind, List<Point2D> asked, BooleanSupplier wanted) {
        // places are those of the photograph in its own size
        RenderPlan plan = RenderPlan.of(picture.studio(), picture.plan());
        List<Vector2dc> places = asked.stream()
                .map(place -> (Vector2dc) new Vector2d(place.getX(), place.getY()))
                .toList();
        int count = Profile.count(places.get(0), places.get(1));
        try {
            return new Answer(Measurements.measure(plan, kind, places, count, wanted), "");
        } catch (ArithmeticException noFit) {
            return new Answer(null, noFit.getMessage());
        }
    }

    @Override
    public void close() {
        newest = null;
        worker.close();
    }
}
