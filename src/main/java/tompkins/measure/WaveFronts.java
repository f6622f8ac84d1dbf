package tompkins.measure;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.DoubleStream;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import tompkins.light.Pulse;
import tompkins.trace.EmissionTimes;
import tompkins.trace.RenderPlan;

/**
 * Where the first light of flashes is in a picture. The times at which the light left a lamp are worked out at the
 * corners of triangles; where the beginning of a flash lies between those of two corners, the front is searched for on
 * the side between them, and drawn straight from side to side. Triangles at edges of what is lit are divided.
 */
final class WaveFronts {

    /** Parts of the longer edge of the picture, each with two triangles in a square. */
    private static final int PARTS = 128;

    /** The smallest triangles have sides of this part of the largest. */
    private static final int SMALLEST = 8;

    /** A side is halved so often: to a tenth of a pixel in a picture of 1000 pixels. */
    private static final int HALVINGS = 7;

    /** What is left of a difference that is no jump from one surface to another, at most. */
    private static final double LEFT = 0.25;

    /** A corner of triangles, in the smallest sides of them. */
    private record Corner(int column, int row) {

        static Corner between(Corner one, Corner other) {
            return new Corner((one.column + other.column) / 2, (one.row + other.row) / 2);
        }
    }

    private final EmissionTimes emission;
    private final int columns;
    private final int rows;
    private final double width;
    private final double height;
    private final Map<Corner, double[]> known = new HashMap<>();
    private final List<List<Vector2dc>> lines = new ArrayList<>();

    private WaveFronts(RenderPlan plan) {
        emission = new EmissionTimes(plan);
        double part = (double) Math.max(plan.width(), plan.height()) / PARTS;
        columns = SMALLEST * (int) Math.ceil(plan.width() / part);
        rows = SMALLEST * (int) Math.ceil(plan.height() / part);
        width = (double) plan.width() / columns;
        height = (double) plan.height() / rows;
    }

    /** The fronts of all flashes in a picture, in pixels, each as short pieces. */
    static List<List<Vector2dc>> lines(RenderPlan plan) {
        if (!plan.hasFlashes()) {
            return List.of();
        }
        WaveFronts fronts = new WaveFronts(plan);
        for (int lamp = 0; lamp < fronts.emission.flashes().size(); lamp++) {
            for (int row = 0; row < fronts.rows; row += SMALLEST) {
                for (int column = 0; column < fronts.columns; column += SMALLEST) {
                    Corner right = new Corner(column + SMALLEST, row);
                    Corner left = new Corner(column, row + SMALLEST);
                    fronts.add(lamp, new Corner(column, row), right, left, SMALLEST);
                    fronts.add(lamp, new Corner(column + SMALLEST, row + SMALLEST), left, right, SMALLEST);
                }
            }
        }
        return fronts.lines;
    }

    /** Adds the front of a lamp in a triangle, whose shorter sides have a size and begin at the first corner. */
    private void add(int lamp, Corner first, Corner second, Corner third, int size) {
        double[] begun = {begun(lamp, first), begun(lamp, second), begun(lamp, third)};
        double range =
                Math.max(begun[0], Math.max(begun[1], begun[2])) - Math.min(begun[0], Math.min(begun[1], begun[2]));
        if (range == 0 || DoubleStream.of(begun).allMatch(Double::isNaN)) {
            return;
        }
        List<Vector2dc> piece = new ArrayList<>();
        if (range == 1) {
            addCrossing(lamp, first, second, piece);
            addCrossing(lamp, first, third, piece);
            addCrossing(lamp, second, third, piece);
        }
        if (piece.size() == 2) {
            lines.add(List.copyOf(piece));
        } else if (size > 1) {
            Corner a = Corner.between(first, second);
            Corner b = Corner.between(first, third);
            Corner c = Corner.between(second, third);
            add(lamp, first, a, b, size / 2);
            add(lamp, a, second, c, size / 2);
            add(lamp, b, c, third, size / 2);
            add(lamp, c, b, a, size / 2);
        }
    }

    private Vector2d point(Corner corner) {
        return new Vector2d(corner.column * width, corner.row * height);
    }

    private double time(int lamp, Corner corner) {
        return known.computeIfAbsent(corner, each -> emission.at(each.column * width, each.row * height))[lamp];
    }

    private double begun(int lamp, Corner corner) {
        return begun(emission.flashes().get(lamp), time(lamp, corner));
    }

    /** The number of the last flash that has begun at a time; no number if there is no time. */
    private static double begun(Pulse flash, double time) {
        if (Double.isNaN(time)) {
            return Double.NaN;
        }
        // the only flash has the number 0, before and after
        return flash.phase(time) < 0 ? -1 : flash.cycle(time);
    }

    /** Adds where a front crosses a side, if one does, and the time does not jump there, from surface to surface. */
    private void addCrossing(int lamp, Corner first, Corner last, List<Vector2dc> piece) {
        Pulse flash = emission.flashes().get(lamp);
        double before = time(lamp, first);
        double after = time(lamp, last);
        double whole = Math.abs(after - before);
        double low = begun(flash, before);
        if (begun(flash, after) == low) {
            return;
        }
        Vector2d from = point(first);
        Vector2d to = point(last);
        for (int i = 0; i < HALVINGS; i++) {
            Vector2d middle = from.lerp(to, 0.5, new Vector2d());
            double time = emission.at(middle.x, middle.y)[lamp];
            if (begun(flash, time) == low) {
                from = middle;
                before = time;
            } else {
                // where nothing is lit there is no front: then the difference is no number
                to = middle;
                after = time;
            }
        }
        if (Math.abs(after - before) < LEFT * whole) {
            piece.add(from.lerp(to, 0.5));
        }
    }
}
