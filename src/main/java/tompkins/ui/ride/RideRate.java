package tompkins.ui.ride;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Locale;
import tompkins.ui.picture.Picture;
import tompkins.ui.widget.Texts;

/** How many pictures of a ride there are in a second, and how good they are. */
final class RideRate {

    private static final long SECOND = 1_000_000_000;

    private final Deque<Long> times = new ArrayDeque<>();
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
    String text() {
        return Texts.get(
                "ride.rate", times.size(), String.format(Locale.ROOT, "%.2f", last == null ? 0 : last.samples()));
    }
}
