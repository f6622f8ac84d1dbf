package tompkins.trace;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import tompkins.light.AlwaysOn;
import tompkins.light.Lighting;
import tompkins.light.PointLight;
import tompkins.light.Pulse;
import tompkins.light.RestingLight;
import tompkins.light.Sightline;
import tompkins.ray.Hit;
import tompkins.world.FlashTimes;
import tompkins.world.LitSpan;
import tompkins.world.Surroundings;

/** Finds what flash lamps do at the hits of rays. */
final class FlashWatch {

    private final List<RestingLight> lamps;
    private final Surroundings scene;
    private final Surroundings beforeLens;
    private final FlashTimes times;
    private final Sightline sight = new Sightline();

    /**
     * A watch over some lamps.
     *
     * @param lamps the lights of the scene, those that flash and the others
     * @param scene has the ways to them from hits in the scene
     * @param beforeLens has the ways to them from hits in the camera frame
     * @param times finds when a hit in the scene is lit
     */
    FlashWatch(List<RestingLight> lamps, Surroundings scene, Surroundings beforeLens, FlashTimes times) {
        this.lamps = lamps;
        this.scene = scene;
        this.beforeLens = beforeLens;
        this.times = times;
    }

    /** What each flash lamp does at a hit. */
    List<FlashSight> at(Hit hit) {
        boolean isStraight = hit.ray.depth == 0;
        Lighting lighting = lighting(hit);
        List<FlashSight> sights = new ArrayList<>();
        for (int i = 0, lamp = 0; i < lamps.size(); i++) {
            lamp += lamps.get(i) instanceof PointLight ? 1 : 0;
            if (lamps.get(i).flash() instanceof Pulse flash) {
                double emission = lighting.find(i, hit, sight) ? sight.emission : Double.NaN;
                sights.add(new FlashSight(
                        lamp,
                        flash,
                        emission,
                        reaches(lighting, i, hit),
                        isStraight,
                        isStraight ? spans(i, flash, emission, hit) : List.of()));
            }
        }
        return sights;
    }

    /**
     * When the light that reaches a hit now left each flash lamp, in its own time; no number where none does, on the
     * dark side of a surface and in a shadow.
     *
     * @param emissions receives the times, in the order of the flash lamps
     */
    void findEmissions(Hit hit, double[] emissions) {
        for (int i = 0, found = 0; i < lamps.size(); i++) {
            if (lamps.get(i).flash() instanceof Pulse) {
                emissions[found++] = reaches(lighting(hit), i, hit) ? sight.emission : Double.NaN;
            }
        }
    }

    private boolean isInScene(Hit hit) {
        return hit.frame != beforeLens.home();
    }

    private Lighting lighting(Hit hit) {
        return (isInScene(hit) ? scene : beforeLens).lighting();
    }

    private boolean reaches(Lighting lighting, int source, Hit hit) {
        return lighting.find(source, hit, sight)
                && sight.reaches(hit.ray, hit, AlwaysOn.DEFAULT)
                && lighting.isClear(source, hit, sight);
    }

    /** The spans of the flash that began last, and of those before and after it, if there are such. */
    private List<LitSpan> spans(int source, Pulse flash, double emission, Hit hit) {
        double cycle = Double.isNaN(emission) ? 0 : flash.cycle(emission);
        return (flash.period() > 0 ? IntStream.rangeClosed(-1, 2) : IntStream.of(0))
                .mapToObj(later -> isInScene(hit)
                        ? times.of(source, flash, cycle + later, hit.ray, hit)
                        : inCamera(flash, cycle + later, emission))
                .flatMap(List::stream)
                .toList();
    }

    private static List<LitSpan> inCamera(Pulse flash, double cycle, double emission) {
        double begin = flash.start() + cycle * flash.period() - emission;
        return List.of(new LitSpan(begin, begin + flash.duration()));
    }
}
