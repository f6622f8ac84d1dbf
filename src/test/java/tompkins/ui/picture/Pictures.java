package tompkins.ui.picture;

import java.awt.Component;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.time.Duration;
import java.util.List;
import java.util.function.IntPredicate;
import tompkins.image.LinearImage;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/** Whole pictures that nobody rendered, for what shows and reads them. */
public final class Pictures {

    private Pictures() {}

    /** A black picture in the size of its photograph. */
    public static Picture black(Studio studio) {
        return black(studio, studio.settings().width(), studio.settings().height());
    }

    /** A black picture of a studio that may have another size on the screen. */
    public static Picture black(Studio studio, int width, int height) {
        RenderPlan plan = RenderPlan.of(studio.withSettings(studio.settings().withSize(width, height)));
        return of(studio, plan, new LinearImage(width, height, new float[3 * width * height]), Double.NaN);
    }

    /** A picture with one sample of each pixel. */
    public static Picture of(Studio studio, RenderPlan plan, LinearImage image, double error, String... warnings) {
        return new Picture(
                studio, plan, image, null, true, Duration.ZERO, 1, error, List.of(warnings), Picture.Flaw.NONE);
    }

    /** The smallest rectangle around the pixels of a picture that are marked, by their number, row by row. */
    public static Rectangle around(int width, int height, IntPredicate marked) {
        Rectangle found = new Rectangle(-1, -1);
        for (int i = 0; i < width * height; i++) {
            if (marked.test(i)) {
                found = found.union(new Rectangle(i % width, i / width, 1, 1));
            }
        }
        return found;
    }

    /** The colours of what is painted of a component. */
    public static int[] painted(Component component) {
        int width = component.getWidth();
        int height = component.getHeight();
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        component.paint(image.createGraphics());
        return image.getRGB(0, 0, width, height, null, 0, width);
    }
}
