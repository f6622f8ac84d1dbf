package tompkins.trace;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import tompkins.light.Lighting;
import tompkins.light.PointLight;
import tompkins.light.Pulse;
import tompkins.light.RestingLight;
import tompkins.light.Sightline;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.world.FlashTimes;
import tompkins.world.LitSpan;

/** Finds what flash lamps do at the hits of rays. */
final class FlashWatch {

    private final List<RestingLight> lamps;
    private final Lighting inScene;
    private final Lighting inCamera;
    private final FlashTimes times;
    private final Sightline sight = new Sightline();

    /**
     * A watch over some lamps.
     *
     * @param lamps the lights of the scene, those that flash and the others
     * @param inScene finds ways to them from hits in the scene
     * @param inCamera finds ways to them from hits in the camera frame
     * @param times finds when a hit in the scene is lit
     */
    FlashWatch(List<RestingLight> lamps, Lighting inScene, Lighting inCamera, FlashTimes times) {
        this.lamps = lamps;
        this.inScene = inScene;
        this.inCamera = inCamera;
        this.times = times;
    }

    /**
     * What each flash lamp does at a hit.
     *
     * @param isStraight whether the ray has come from the camera without a surface on the way
     */
    List<FlashSight> at(Frame frame, Ray ray, Hit hit, boolean isStraight) {
        List<FlashSight> sights = new ArrayList<>();
        for (int i = 0, lamp = 0; i < lamps.size(); i++) {
            lamp += lamps.get(i) instanceof PointLight ? 1 : 0;
            if (lamps.get(i).flash() instanceof Pulse flash) {
                boolean arrives = (frame == Frame.SCENE ? inScene : inCamera).find(i, hit, sight);
                double emission = arrives ? sight.emission : Double.NaN;
                sights.add(new FlashSight(
                        lamp,
                        flash,
                        emission,
                        isStraight,
                        isStraight ? spans(i, flash, emission, frame, ray, hit) : List.of()));
            }
        }
        return sights;
    }

    /** The spans of the flash that began last and of the next, if there is a next: those that are nearer. */
    private List<LitSpan> spans(int source, Pulse flash, double emission, Frame frame, Ray ray, Hit hit) {
        double cycle = Double.isNaN(emission) ? 0 : flash.cycle(emission);
        return IntStream.rangeClosed(0, flash.period() > 0 ? 1 : 0)
                .mapToObj(next -> frame == Frame.SCENE
                        ? times.of(source, flash, cycle + next, ray, hit)
                        : inCamera(flash, cycle + next, emission))
                .filter(spans -> !spans.isEmpty())
                .min(Comparator.comparingDouble(FlashWatch::distance))
                .orElse(List.of());
    }

    private static List<LitSpan> inCamera(Pulse flash, double cycle, double emission) {
        double begin = flash.start() + cycle * flash.period() - emission;
        return List.of(new LitSpan(begin, begin + flash.duration()));
    }

    private static double distance(List<LitSpan> spans) {
        return Stream.of(spans.get(0), spans.get(spans.size() - 1))
                .mapToDouble(LitSpan::distance)
                .min()
                .getAsDouble();
    }
}
