package tompkins.render;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import tompkins.trace.RenderPlan;

/**
 * What a picture will cost on this machine, told from taking parts of it for about two seconds.
 *
 * @param samplesPerPixel mean number of samples of a pixel
 * @param seconds time of the render
 */
public record CostForecast(double samplesPerPixel, double seconds) {

    private static final double PATIENCE = 2;
    private static final double FIRST_SHARE = 1.0 / 8;
    private static final double GOLDEN = (Math.sqrt(5) - 1) / 2;

    /**
     * Takes more and more of the picture's tiles, spread over it, until it knows enough. The machine gets faster while the
     * program runs warm, so what is left is counted with the speed of the fastest part.
     */
    public static CostForecast of(RenderPlan plan, Quality quality, Renderer renderer) throws InterruptedException {
        List<Tile> tiles = spread(Tile.of(plan.width(), plan.height()));
        double pixels = (double) plan.width() * plan.height();
        Quality wish = quality instanceof Quality.TimeLimit ? Quality.TargetError.DEFAULT : quality;
        double samples = 0;
        double expected = 0;
        double area = 0;
        double seconds = 0;
        double rate = 0;
        int from = 0;
        while (from < tiles.size() && seconds < PATIENCE) {
            int to = Math.min(tiles.size(), Math.max(2 * from, (int) Math.ceil(tiles.size() * FIRST_SHARE)));
            List<Tile> part = tiles.subList(from, to);
            RenderJob job = renderer.start(plan, wish, false, part, RenderListener.NONE);
            double progress = job.await(PATIENCE) ? 1 : job.progress();
            job.cancel();
            job.await();
            RenderReport report = job.report();
            double time = report.time().toNanos() / 1e9;
            samples += report.samples();
            expected += report.samples() / progress;
            area += part.stream()
                    .mapToDouble(tile -> tile.width() * tile.height())
                    .sum();
            seconds += time;
            rate = Math.max(rate, report.samples() / time);
            from = to;
        }
        if (quality instanceof Quality.TimeLimit limit) {
            return new CostForecast(rate * limit.seconds() / pixels, limit.seconds());
        }
        double all = expected / area * pixels;
        return new CostForecast(all / pixels, seconds + Math.max(0, all - samples) / rate);
    }

    /** The tiles in an order in which any number of first ones lie all over the picture. */
    private static List<Tile> spread(List<Tile> tiles) {
        List<Integer> order = new ArrayList<>();
        for (int i = 0; i < tiles.size(); i++) {
            order.add(i);
        }
        order.sort(Comparator.comparingDouble(i -> i * GOLDEN - Math.floor(i * GOLDEN)));
        return order.stream().map(tiles::get).toList();
    }
}
