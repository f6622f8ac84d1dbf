package tompkins.trace;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import org.joml.Vector2dc;
import org.joml.Vector3dc;
import tompkins.camera.CameraRays;
import tompkins.camera.ConcentricMap;
import tompkins.ray.Colour;

/**
 * Where stars are seen in a picture if nothing is in the way, sorted into cells, and the light of each. Immutable,
 * shared by all threads.
 *
 * <p>A star is a spot of fixed width in pixels: a bell curve of the distance between star and centre of a pixel, whose
 * sum over all pixels is 1. So its light does not depend on the samples, nor on where in a pixel it stands. Out of
 * focus it is many such spots, one for each of some points spread evenly over the lens.
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

    /** The most spots of all stars together, so that their places need little memory. */
    private static final int MOST_SPOTS = 2_000_000;

    private final CameraRays camera;
    private final int width;
    private final int height;
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
     * @param wideAperture whether what is out of focus is blurred
     * @param directions unit vectors in the camera frame; null for a star that is not seen
     * @param lights for each star, its light: radiance of white times solid angle
     * @param unwanted whether the picture is no longer wanted; asked for each spot, whose place may take microseconds
     * @throws java.util.concurrent.CancellationException if {@code unwanted} says so
     */
    StarPoints(
            CameraRays camera,
            int width,
            int height,
            boolean wideAperture,
            List<? extends Vector3dc> directions,
            List<Colour> lights,
            BooleanSupplier unwanted) {
        this.camera = camera;
        this.width = width;
        this.height = height;
        cellsAcross = (width + CELL - 1) / CELL;
        cellsDown = (height + CELL - 1) / CELL;
        List<Vector2dc> places = new ArrayList<>();
        List<Colour> colours = new ArrayList<>();
        int[] sides = directions.stream()
                .mapToInt(direction -> direction == null ? 0 : wideAperture ? lensSide(direction, unwanted) : 1)
                .toArray();
        double spots =
                IntStream.of(sides).mapToDouble(side -> (double) side * side).sum();
        double fewer = Math.min(1, Math.sqrt(MOST_SPOTS / spots));
        for (int star = 0; star < directions.size(); star++) {
            Vector3dc direction = directions.get(star);
            if (sides[star] == 0) {
                continue;
            }
            int side = Math.max(1, (int) (fewer * sides[star]));
            Colour colour = lights.get(star).times(1.0 / (side * side));
            for (int i = 0; i < side * side; i++) {
                Cancellation.stopIf(unwanted);
                double radius = ConcentricMap.radius((i % side + 0.5) / side, (i / side + 0.5) / side);
                double angle = ConcentricMap.angle((i % side + 0.5) / side, (i / side + 0.5) / side);
                for (Vector2dc place :
                        camera.positions(direction, radius * Math.cos(angle), radius * Math.sin(angle))) {
                    if (isNear(place, RADIUS)) {
                        places.add(place);
                        colours.add(colour);
                    }
                }
            }
        }
        x = places.stream().mapToDouble(Vector2dc::x).toArray();
        y = places.stream().mapToDouble(Vector2dc::y).toArray();
        light = colours.toArray(Colour[]::new);
        near = new CellLists(cellsAcross * cellsDown, x.length, this::forEachCell);
    }

    /**
     * So many spots in a row, across the disc of a star out of focus, look smooth: they are half a pixel apart in a
     * small disc, and a pixel in a large one. 0 if the disc is not in the picture.
     */
    private int lensSide(Vector3dc direction, BooleanSupplier unwanted) {
        Cancellation.stopIf(unwanted);
        List<Vector2dc> left = camera.positions(direction, -1, 0);
        List<Vector2dc> right = camera.positions(direction, 1, 0);
        double blur = left.size() == 1 && right.size() == 1 ? left.get(0).distance(right.get(0)) : Double.NaN;
        if (!(blur < MOST_SPOTS)) {
            return 1;
        }
        // from its left edge; with the surface in focus aslant it may be higher than wide
        return isNear(left.get(0), RADIUS + 2 * blur)
                ? (int) Math.min(1 + Math.ceil(2 * blur), 4 + Math.ceil(blur))
                : 0;
    }

    /** Whether a place lies in the picture, or not farther from it than a distance in pixels. */
    private boolean isNear(Vector2dc place, double distance) {
        return Math.abs(place.x() - width / 2.0) < width / 2.0 + distance
                && Math.abs(place.y() - height / 2.0) < height / 2.0 + distance;
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
