package tompkins.trace;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
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
                Lighting lighting = frame == Frame.SCENE ? inScene : inCamera;
                boolean arrives = lighting.find(i, hit, sight);
                double emission = arrives ? sight.emission : Double.NaN;
                sights.add(new FlashSight(
                        lamp,
                        flash,
                        emission,
                        reaches(lighting, i, ray, hit),
                        isStraight,
                        isStraight ? spans(i, flash, emission, frame, ray, hit) : List.of()));
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
    void findEmissions(Frame frame, Ray ray, Hit hit, double[] emissions) {
        Lighting lighting = frame == Frame.SCENE ? inScene : inCamera;
        for (int i = 0, found = 0; i < lamps.size(); i++) {
            if (lamps.get(i).flash() instanceof Pulse) {
                emissions[found++] = reaches(lighting, i, ray, hit) ? sight.emission : Double.NaN;
            }
        }
    }

    private boolean reaches(Lighting lighting, int source, Ray ray, Hit hit) {
        if (!lighting.find(source, hit, sight) || sight.length == 0) {
            return false;
        }
        double alongNormal = sight.x * hit.normalX + sight.y * hit.normalY + sight.z * hit.normalZ;
        return alongNormal * hit.cosine(ray) < 0 && lighting.isClear(source, hit, sight);
    }

    /** The spans of the flash that began last, and of those before and after it, if there are such. */
    private List<LitSpan> spans(int source, Pulse flash, double emission, Frame frame, Ray ray, Hit hit) {
        double cycle = Double.isNaN(emission) ? 0 : flash.cycle(emission);
        return (flash.period() > 0 ? IntStream.rangeClosed(-1, 2) : IntStream.of(0))
                .mapToObj(later -> frame == Frame.SCENE
                        ? times.of(source, flash, cycle + later, ray, hit)
                        : inCamera(flash, cycle + later, emission))
                .flatMap(List::stream)
                .toList();
    }

    private static List<LitSpan> inCamera(Pulse flash, double cycle, double emission) {
        double begin = flash.start() + cycle * flash.period() - emission;
        return List.of(new LitSpan(begin, begin + flash.duration()));
    }
}
