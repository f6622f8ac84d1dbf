package tompkins.ui.picture;

import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import tompkins.explain.Explanation;
import tompkins.image.BufferedImages;
import tompkins.image.LinearImage;
import tompkins.render.Quality;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/**
 * A picture on its way to the screen. It may be larger or smaller than its photograph, whose size is the studio's own:
 * places are given in pixels of the photograph.
 *
 * @param studio the studio that is photographed
 * @param plan what it was made from, in the size of the picture
 * @param image its light; null if it is a glimpse, which is only looked at
 * @param glimpse its levels if it is a glimpse, or null
 * @param complete whether all samples were taken
 * @param time since the change that it answers
 * @param samples mean number of samples of a pixel
 * @param error estimated root mean square error; NaN while it is not known
 * @param warnings what went wrong; known when it is complete
 * @param flaw what spoils it; known when it is complete
 */
public record Picture(
        Studio studio,
        RenderPlan plan,
        LinearImage image,
        BufferedImage glimpse,
        boolean complete,
        Duration time,
        double samples,
        double error,
        List<String> warnings,
        Flaw flaw) {

    /** What spoils a whole picture and can be put right at once. */
    public enum Flaw {
        /** No known flaw. */
        NONE,
        /** The motion makes more than half of it brighter than white. */
        BURNT,
        /** No ray met an object of the scene. */
        EMPTY
    }

    /** How the screen shows it, in its own size. */
    public BufferedImage levels() {
        return glimpse != null
                ? glimpse
                : BufferedImages.toBufferedImage(image, studio.settings().toneCurve());
    }

    /** The width of the picture, in pixels. */
    public int width() {
        return plan.width();
    }

    /** The height of the picture, in pixels. */
    public int height() {
        return plan.height();
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
        List<String> sentences = new ArrayList<>(new Explanation(plan).sentences());
        sentences.add(quality().sentence(plan));
        return sentences;
    }

    /** The width of the photograph in its own size, in pixels. */
    public int ownWidth() {
        return studio.settings().width();
    }

    /** The height of the photograph in its own size, in pixels. */
    public int ownHeight() {
        return studio.settings().height();
    }

    /** Whether it has the pixels of the photograph. */
    public boolean isOfOwnSize() {
        return width() == ownWidth() && height() == ownHeight();
    }

    /** Whether it has a size, in pixels. */
    public boolean isOfSize(Dimension size) {
        return width() == size.width && height() == size.height;
    }

    /** Whether a place of the photograph lies on it. */
    public boolean holds(Point2D place) {
        return new Rectangle(ownWidth(), ownHeight()).contains(place);
    }

    /** A place of the photograph in pixels of the picture. */
    public Point2D inPixels(Point2D place) {
        return new Point2D.Double(place.getX() * width() / ownWidth(), place.getY() * height() / ownHeight());
    }

    /** The middle of the pixel of the picture that is nearest to a place, as a place of the photograph. */
    Point2D middle(int column, int row) {
        return new Point2D.Double(
                (Math.min(column, width() - 1) + 0.5) * ownWidth() / width(),
                (Math.min(row, height() - 1) + 0.5) * ownHeight() / height());
    }
}
