package tompkins.world;

import java.util.ArrayList;
import java.util.List;
import tompkins.spacetime.Event;

/**
 * A span of the camera's time in which what it sees in one direction is lit by a flash. Both ends count from the time
 * of the hit in question, and either can be infinite.
 *
 * @param from when the light begins
 * @param to when it ends
 */
public record LitSpan(double from, double to) {

    /**
     * When a place is lit that runs along a straight line of events: once, or twice if the place runs past the lamp
     * faster than light. All events are those of a frame in which light has speed 1.
     *
     * @param begin the event at which the lamp is switched on
     * @param end the event at which it is switched off
     * @param hit the event of the line at the time 0 of the spans
     * @param shift how the event changes in one unit of that time
     * @param square square of the length of that change minus square of its time: at high speed it is known better than
     *     from the difference
     */
    static List<LitSpan> of(Event begin, Event end, Event hit, Event shift, double square) {
        LitSpan since = since(begin, hit, shift, square);
        LitSpan after = since(end, hit, shift, square);
        List<LitSpan> spans = new ArrayList<>();
        if (since == null || after == null) {
            return since == null ? spans : List.of(since);
        }
        if (since.from < after.from) {
            spans.add(new LitSpan(since.from, after.from));
        }
        if (after.to < since.to) {
            spans.add(new LitSpan(after.to, since.to));
        }
        return spans;
    }

    /**
     * When the line is within reach of light from an event: A + e W &gt;= |r + e w|, with the difference (r, A) of hit
     * and event and the shift (w, W). The reach of light is convex, so this is one span, or null if it is empty.
     */
    private static LitSpan since(Event event, Event hit, Event shift, double square) {
        Event r = hit.minus(event);
        double distance = r.position().length();
        double mixed = r.position().dot(shift.position()) - r.time() * shift.time();
        double constant = (distance - r.time()) * (distance + r.time());
        double discriminant = mixed * mixed - square * constant;
        if (discriminant < 0) {
            return null;
        }
        double sum = -mixed - Math.copySign(Math.sqrt(discriminant), mixed);
        double one = sum == 0 ? 0 : constant / sum;
        double other = square == 0 ? Math.copySign(Double.POSITIVE_INFINITY, mixed) : sum / square;
        double first = Math.min(one, other);
        double last = Math.max(one, other);
        if (square > 0) {
            boolean isLater = r.time() + (first + last) / 2 * shift.time() > 0;
            return isLater ? new LitSpan(first, last) : null;
        }
        return new LitSpan(last, Double.POSITIVE_INFINITY);
    }
}
