package tompkins.ui.ride;

import java.awt.image.BufferedImage;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Locale;
import tompkins.studio.LensEvent;
import tompkins.studio.Studio;
import tompkins.ui.number.SceneSize;
import tompkins.ui.picture.Picture;
import tompkins.ui.widget.Texts;

/** What the pictures of a ride tell: how many there are in a second, and whether there is anything to see in them. */
final class RideReading {

    private static final long SECOND = 1_000_000_000;

    /** So many points across and down are looked at. */
    private static final int GRID = 16;

    /** The largest level. */
    private static final int TOP = 255;

    /** Levels that differ by no more are one colour. */
    private static final int SAME = 20;

    /** The scene is left at so many times the distance of its farthest object from the origin. */
    private static final double OUTSIDE = 2;

    private final Deque<Long> times = new ArrayDeque<>();
    private final SceneSize size = new SceneSize();
    private Picture last;

    /** Takes note of the picture on the screen, if it is another one. */
    void note(Picture picture) {
        long now = System.nanoTime();
        if (picture != last) {
            last = picture;
            times.add(now);
        }
        while (!times.isEmpty() && now - times.peek() > SECOND) {
            times.remove();
        }
    }

    /** Pictures and samples, in words. */
    String rate() {
        return Texts.get(
                "ride.rate", times.size(), String.format(Locale.ROOT, "%.2f", last == null ? 0 : last.samples()));
    }

    /** Why there is nothing to see; empty if there is something. */
    String trouble(Picture picture) {
        Studio studio = picture.studio();
        if (LensEvent.inScene(studio).position().length() > OUTSIDE * size.of(studio)) {
            return Texts.get("ride.outside");
        }
        return isOneColour(picture.levels()) ? Texts.get("ride.blind") : "";
    }

    /** Whether a picture shows one colour from edge to edge. */
    static boolean isOneColour(BufferedImage image) {
        int[] least = {TOP, TOP, TOP};
        int[] most = {0, 0, 0};
        for (int i = 0; i < GRID * GRID; i++) {
            int x = (2 * (i % GRID) + 1) * image.getWidth() / (2 * GRID);
            int y = (2 * (i / GRID) + 1) * image.getHeight() / (2 * GRID);
            for (int channel = 0; channel < 3; channel++) {
                int level = image.getRGB(x, y) >> 8 * channel & TOP;
                least[channel] = Math.min(least[channel], level);
                most[channel] = Math.max(most[channel], level);
                if (most[channel] - least[channel] > SAME) {
                    return false;
                }
            }
        }
        return true;
    }
}
