package tompkins.render;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import tompkins.property.NumberText;
import tompkins.ray.RayPacket;
import tompkins.trace.RenderPlan;

/**
 * What a picture will cost on this machine, as busy as it is now, estimated by rendering blocks of it for about three
 * seconds.
 *
 * @param samplesPerPixel mean number of samples of a pixel
 * @param seconds time of the render
 */
public record CostForecast(double samplesPerPixel, double seconds) {

    /** Seconds in which the program has warmed up. */
    private static final double PATIENCE = 3;

    /** The time of blocks may be so many times that of the picture, which is warm and keeps all threads at work. */
    private static final double MOST_TOO_LONG = 2;

    private static final double MOST_TOO_SHORT = 1.5;

    /** Short enough to distinguish the speed of the program before and after it has warmed up. */
    private static final double PART = 1;

    private static final double LONGEST_PART = 4;

    /** Number of blocks that are needed for their mean to be within some tens of percent of the mean of all. */
    private static final int FIRST_BLOCKS = 32;

    /** Multiples of these two, without whole parts, fill the unit interval evenly over the plane (Roberts 2018). */
    private static final double ACROSS = 0.7548776662466927;

    private static final double DOWN = 0.5698402909980532;

    /**
     * Takes a few blocks of pixels, spread over the picture, exactly as the picture would be taken, and then as many
     * more as there is time for. The whole picture is taken to need what the blocks need.
     *
     * @return the forecast, or empty if not even one sample was complete in that time
     */
    public static Optional<CostForecast> of(RenderPlan plan, Quality quality, Renderer renderer)
            throws InterruptedException {
        return of(plan, quality, renderer, PATIENCE);
    }

    /** As above; blocks beyond the first are taken only until {@code patience} seconds have passed. */
    static Optional<CostForecast> of(RenderPlan plan, Quality quality, Renderer renderer, double patience)
            throws InterruptedException {
        Quality wish = quality instanceof Quality.TimeLimit ? Quality.TargetError.DEFAULT : quality;
        List<Tile> blocks = spread(plan);
        ForecastSamples costs = new ForecastSamples();
        long start = System.nanoTime();
        int taken = take(blocks.subList(0, Math.min(blocks.size(), FIRST_BLOCKS)), plan, wish, renderer, costs);
        for (double spent = secondsSince(start);
                taken < blocks.size() && spent < patience;
                spent = secondsSince(start)) {
            double possible = taken * Math.min(PART, patience - spent) / spent;
            int next = (int) Math.min(blocks.size(), taken + Math.ceil(possible));
            taken += take(blocks.subList(taken, next), plan, wish, renderer, costs);
        }
        if (costs.isEmpty()) {
            return Optional.empty();
        }
        long pixels = plan.studio().settings().pixels();
        if (quality instanceof Quality.TimeLimit limit) {
            return Optional.of(new CostForecast(costs.rate() * limit.seconds() / pixels, limit.seconds()));
        }
        double perPixel = quality instanceof Quality.Samples fixed ? fixed.samples() : costs.samplesPerPixel();
        return Optional.of(new CostForecast(perPixel, costs.seconds(perPixel * pixels)));
    }

    /** The time in words: from the least to the most that is likely. */
    public String duration() {
        double most = MOST_TOO_SHORT * seconds;
        return most < 1
                ? "less than a second"
                : NumberText.plain(seconds / MOST_TOO_LONG, 1) + " to " + NumberText.plain(most, 1) + " s";
    }

    /** Takes some blocks, and says how many. */
    private static int take(
            List<Tile> blocks, RenderPlan plan, Quality quality, Renderer renderer, ForecastSamples costs)
            throws InterruptedException {
        long start = System.nanoTime();
        RenderJob job = renderer.start(plan, quality, false, blocks, RenderListener.NONE);
        job.await(LONGEST_PART);
        job.cancel();
        job.await();
        double seconds = secondsSince(start);
        costs.add(
                blocks.stream().mapToInt(Tile::pixels).sum(),
                job.samples(),
                job.progress(),
                seconds,
                job.planningSeconds());
        return blocks.size();
    }

    private static double secondsSince(long start) {
        return (System.nanoTime() - start) / 1e9;
    }

    /** The blocks of a picture in an order in which the first n, for any n, are spread all over it. */
    private static List<Tile> spread(RenderPlan plan) {
        int side = RayPacket.SIDE;
        return Tile.of(plan.width(), plan.height(), side).stream()
                .sorted(Comparator.comparingDouble(
                        block -> (ACROSS * (block.column() / side) + DOWN * (block.row() / side)) % 1))
                .toList();
    }
}
