package tompkins.study;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import tompkins.render.Quality;
import tompkins.studio.Studio;

/** Speed against accuracy of one picture, made smaller, for choosing a quality: only what can be chosen is measured. */
public final class PictureStudy {

    private static final String PICTURE = "picture";
    private static final Set<String> CHOICES =
            Set.of(AntialiasingStudy.CENTRE, AntialiasingStudy.FIXED, AntialiasingStudy.ADAPTIVE);
    private static final int WIDTH = 80;
    private static final int REFERENCE_SAMPLES = 2048;

    private final List<Trial> trials;

    /** The study of a studio's picture. */
    public PictureStudy(Studio studio) {
        Study study = new AntialiasingStudy(
                Map.of(PICTURE, studio), Map.of(), studio.settings().seed(), WIDTH, REFERENCE_SAMPLES);
        trials = study.trials().stream()
                .filter(trial -> CHOICES.contains(trial.method()))
                .toList();
    }

    /** Number of points of the chart. */
    public int points() {
        return trials.size();
    }

    /** The chart. */
    public Chart chart() {
        return Chart.errorAgainstTime(PICTURE, "This picture, smaller; a click on a point sets the quality");
    }

    /**
     * Measures all points, one after the other.
     *
     * @param listener told of all points so far
     * @throws java.util.concurrent.CancellationException soon after {@code cancelled} became true
     */
    public void measure(Consumer<List<Measurement>> listener, BooleanSupplier cancelled) {
        List<Measurement> measured = new ArrayList<>();
        for (Trial trial : trials) {
            Stopwatch.stopIf(cancelled);
            measured.add(trial.measurer().measure(cancelled));
            listener.accept(List.copyOf(measured));
        }
    }

    /** The quality that a point stands for. */
    public Quality qualityOf(Measurement point) {
        return point.method().equals(AntialiasingStudy.ADAPTIVE)
                ? new Quality.TargetError(point.setting())
                : new Quality.Samples((int) point.setting());
    }
}
