package tompkins.trace;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntConsumer;
import org.joml.Vector2dc;
import org.joml.Vector3dc;
import tompkins.camera.CameraRays;
import tompkins.ray.Colour;

/**
 * Where stars are seen in a picture if nothing is in the way, sorted into cells, and the light of each. Immutable,
 * shared by all threads.
 *
 * <p>A star is a spot of fixed width in pixels: a bell curve of the distance between star and centre of a pixel, whose
 * sum over all pixels is 1. So its light does not depend on the samples, nor on where in a pixel it stands.
 */
final class StarPoints {

    /** Standard deviation of a spot, in pixels. With less the sum over pixels would depend on the place of the star. */
    private static final double DEVIATION = 0.7;

    /** So many standard deviations from its middle a spot ends, with 0.03 % of its light beyond. */
    private static final double EDGE = 4;

    /** Width and height of a cell, in pixels. */
    private static final int CELL = 8;

    /** So far, in pixels, a spot reaches from its middle. */
    static final double RADIUS = EDGE * DEVIATION;

    private final CameraRays camera;
    private final int cellsAcross;
    private final int cellsDown;

    // the places of all spots, and the light of each
    private final double[] x;
    private final double[] y;
    private final Colour[] light;

    /** The spots near each cell. */
    private final CellLists near;

    /**
     * The stars of one picture.
     *
     * @param directions unit vectors in the camera frame; null for a star that is not seen
     * @param lights for each star, its light: radiance of white times solid angle
     */
    StarPoints(CameraRays camera, int width, int height, List<? extends Vector3dc> directions, List<Colour> lights) {
        this.camera = camera;
        cellsAcross = (width + CELL - 1) / CELL;
        cellsDown = (height + CELL - 1) / CELL;
        List<Vector2dc> places = new ArrayList<>();
        List<Colour> colours = new ArrayList<>();
        for (int star = 0; star < directions.size(); star++) {
            Vector3dc direction = directions.get(star);
            for (Vector2dc place : direction == null ? List.<Vector2dc>of() : camera.positions(direction)) {
                // the spot lies in the picture, or reaches into it
                if (Math.abs(place.x() - width / 2.0) < width / 2.0 + RADIUS
                        && Math.abs(place.y() - height / 2.0) < height / 2.0 + RADIUS) {
                    places.add(place);
                    colours.add(lights.get(star));
                }
            }
        }
        x = places.stream().mapToDouble(Vector2dc::x).toArray();
        y = places.stream().mapToDouble(Vector2dc::y).toArray();
        light = colours.toArray(Colour[]::new);
        near = new CellLists(cellsAcross * cellsDown, x.length, this::forEachCell);
    }

    private void forEachCell(int spot, IntConsumer user) {
        int right = cell(x[spot] + RADIUS, cellsAcross);
        int bottom = cell(y[spot] + RADIUS, cellsDown);
        for (int row = cell(y[spot] - RADIUS, cellsDown); row <= bottom; row++) {
            for (int column = cell(x[spot] - RADIUS, cellsAcross); column <= right; column++) {
                user.accept(row * cellsAcross + column);
            }
        }
    }

    private static int cell(double place, int cells) {
        return Math.max(0, Math.min(cells - 1, (int) (place / CELL)));
    }

    /** The light that a pixel gets from stars, as radiance. */
    Colour light(int column, int row) {
        int cell = cell(row, cellsDown) * cellsAcross + cell(column, cellsAcross);
        Colour sum = null;
        for (int i = near.begin(cell); i < near.end(cell); i++) {
            int spot = near.number(i);
            double fraction = fraction(column + 0.5 - x[spot], row + 0.5 - y[spot]);
            if (fraction > 0) {
                Colour more = light[spot].times(fraction);
                sum = sum == null ? more : sum.plus(more);
            }
        }
        return sum == null ? Colour.BLACK : sum.times(1 / camera.solidAngle(column, row));
    }

    /**
     * The fraction of a star's light that a pixel gets.
     *
     * @param dx from the star to the centre of the pixel, in pixels
     * @param dy as dx, downwards
     */
    static double fraction(double dx, double dy) {
        double square = (dx * dx + dy * dy) / (DEVIATION * DEVIATION);
        return square < EDGE * EDGE ? Math.exp(-square / 2) / (2 * Math.PI * DEVIATION * DEVIATION) : 0;
    }
}
