package tompkins.ui.picture;

import java.awt.Rectangle;
import java.awt.geom.Point2D;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import tompkins.image.LinearImage;
import tompkins.render.Quality;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/**
 * A picture on its way to the screen.
 *
 * @param plan what it was made from
 * @param image its light
 * @param complete whether all samples were taken
 * @param time since the change that it answers
 * @param samples mean number of samples of a pixel
 * @param error estimated root mean square error; NaN while it is not known
 * @param warnings what went wrong; known when it is complete
 */
public record Picture(
        RenderPlan plan,
        LinearImage image,
        boolean complete,
        Duration time,
        double samples,
        double error,
        List<String> warnings) {

    /** The studio that was photographed. */
    public Studio studio() {
        return plan.studio();
    }

    /** Which samples it gets. */
    public Quality quality() {
        return Quality.of(studio());
    }

    /**
     * Whether its one sample, through the centre of the lens in the middle of the exposure time, leaves a wide aperture
     * or a long exposure without effect.
     */
    public boolean isTooSharp() {
        return plan.blurs() && quality().equals(new Quality.Samples(1));
    }

    /** What it models and which samples it gets, in sentences. */
    public List<String> sentences() {
        List<String> sentences = new ArrayList<>(plan.sentences());
        sentences.add(quality().sentence(plan));
        return sentences;
    }

    /** Whether a place, in pixels, lies on the picture. */
    public boolean holds(Point2D place) {
        return new Rectangle(image.width(), image.height()).contains(place);
    }
}
