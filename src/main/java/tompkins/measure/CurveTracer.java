package tompkins.measure;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleFunction;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import tompkins.camera.EyeView;

/**
 * Draws a curve of points as lines from point to point, which stay within a fifth of a pixel of the curve in the
 * picture. A line ends where there is no point, and at the edge where a panorama begins again.
 */
final class CurveTracer {

    private static final double FLAT = 0.2;
    private static final int FIRST_PARTS = 32;
    private static final int DEEPEST = 14;

    private final Projection projection;
    private final DoubleFunction<Vector2dc> curve;
    private final List<List<Vector2dc>> lines = new ArrayList<>();
    private List<Vector2dc> line = new ArrayList<>();

    private CurveTracer(Projection projection, DoubleFunction<Vector2dc> curve) {
        this.projection = projection;
        this.curve = curve;
    }

    /** The lines of a curve between two numbers; the curve gives null where there is no point. */
    static List<List<Vector2dc>> lines(Projection projection, double from, double to, DoubleFunction<Vector2dc> curve) {
        CurveTracer tracer = new CurveTracer(projection, curve);
        double before = from;
        Vector2dc pointBefore = curve.apply(from);
        for (int i = 1; i <= FIRST_PARTS; i++) {
            double next = from + i * (to - from) / FIRST_PARTS;
            Vector2dc point = curve.apply(next);
            tracer.add(before, pointBefore, next, point, 0);
            before = next;
            pointBefore = point;
        }
        tracer.end();
        return tracer.lines;
    }

    private void add(double from, Vector2dc first, double to, Vector2dc last, int depth) {
        if (first == null && last == null) {
            end();
            return;
        }
        double middle = (from + to) / 2;
        Vector2dc between = curve.apply(middle);
        if (isBeside(first, between, last)) {
            end();
            return;
        }
        boolean whole = first != null && last != null && between != null && !jumps(first, last);
        if (whole && isFlat(first, between, last)) {
            draw(first, last);
        } else if (depth == DEEPEST) {
            end();
        } else {
            add(from, first, middle, between, depth + 1);
            add(middle, between, to, last, depth + 1);
        }
    }

    private boolean jumps(Vector2dc first, Vector2dc last) {
        return Math.abs(first.x() - last.x()) > projection.columnsAround() / 2;
    }

    private static boolean isFlat(Vector2dc first, Vector2dc between, Vector2dc last) {
        Vector2d chord = last.sub(first, new Vector2d());
        Vector2d way = between.sub(first, new Vector2d());
        double length = chord.length();
        double off = length == 0 ? way.length() : Math.abs(chord.x * way.y - chord.y * way.x) / length;
        return off < FLAT && way.length() <= length + FLAT && (length < 40 || off < FLAT / 4);
    }

    /** Whether three points lie on one side beyond the picture, by at least its size. */
    private boolean isBeside(Vector2dc first, Vector2dc between, Vector2dc last) {
        if (first == null || between == null || last == null) {
            return false;
        }
        EyeView view = projection.view();
        double width = view.width();
        double height = view.height();
        double left = Math.min(first.x(), Math.min(between.x(), last.x())) - view.column();
        double right = Math.max(first.x(), Math.max(between.x(), last.x())) - view.column();
        double top = Math.min(first.y(), Math.min(between.y(), last.y())) - view.row();
        double bottom = Math.max(first.y(), Math.max(between.y(), last.y())) - view.row();
        return right < -width || bottom < -height || left > 2 * width || top > 2 * height;
    }

    private void draw(Vector2dc first, Vector2dc last) {
        if (line.isEmpty()) {
            line.add(first);
        }
        line.add(last);
    }

    private void end() {
        if (!line.isEmpty()) {
            lines.add(List.copyOf(line));
            line = new ArrayList<>();
        }
    }
}
