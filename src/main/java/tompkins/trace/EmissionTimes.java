package tompkins.trace;

import java.util.Arrays;
import java.util.List;
import tompkins.camera.SamplePositions;
import tompkins.light.Pulse;
import tompkins.light.RestingLight;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;

/**
 * When the light that reaches what a picture shows left the flash lamps: the wave front of a flash is where that is its
 * start. With lamp and camera at rest these places lie on an ellipsoid whose foci are both. For one thread.
 */
public final class EmissionTimes implements PathObserver {

    private final List<Pulse> flashes;
    private final double[] emissions;
    private final FlashWatch watch;
    private final SampleTracer tracer;

    /** How many weaker branches are being followed, one from the other: the times are those of the main one. */
    private int branch;

    /** The times in the picture that is planned. */
    public EmissionTimes(RenderPlan plan) {
        flashes = plan.world().lights().stream()
                .map(RestingLight::flash)
                .filter(Pulse.class::isInstance)
                .map(Pulse.class::cast)
                .toList();
        emissions = new double[flashes.size()];
        watch = plan.flashWatch();
        tracer = plan.tracer(new RayCounts(), this);
    }

    /** The flashes of the lamps that flash. */
    public List<Pulse> flashes() {
        return flashes;
    }

    /**
     * The own time of each of these lamps at which the light left it that meets now what is seen at a point of the
     * picture, through the centre of the lens and in the middle of the exposure; also behind mirrors and glass. No
     * number where none does: on the background, on the dark side of a surface, and in a shadow.
     *
     * @param x position in pixels; the centre of pixel (i, j) is (i + 1/2, j + 1/2)
     * @param y position in pixels
     */
    public double[] at(double x, double y) {
        Arrays.fill(emissions, Double.NaN);
        tracer.sample(x, y, 0, 0, SamplePositions.MIDDLE);
        return emissions.clone();
    }

    @Override
    public void branches() {
        branch++;
    }

    @Override
    public void returns() {
        branch--;
    }

    @Override
    public void hits(Hit hit) {
        if (branch == 0 && watch != null) {
            watch.findEmissions(hit, emissions);
        }
    }

    @Override
    public void leaves(Ray ray) {
        if (branch == 0) {
            Arrays.fill(emissions, Double.NaN);
        }
    }
}
