package tompkins.trace;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import tompkins.camera.EyeView;
import tompkins.camera.SamplePositions;
import tompkins.ray.Ray;

/**
 * The rays through the centre of a pixel that leave the scene behind mirrors, windows and glass. By them, and not by
 * those of the samples, it is decided how much light of a star the pixel gets: the sum over all pixels would scatter
 * with the places of samples. One for each thread.
 */
final class CentreRays implements PathObserver {

    private final SampleTracer tracer;
    private final List<Ray> leaving = new ArrayList<>();
    private double spread;
    private boolean known;
    private EyeView eye;
    private int column;
    private int row;
    private double lensX;
    private double lensY;
    private double moment;
    private int next;

    /**
     * The rays.
     *
     * @param tracerFor makes a tracer that an observer watches
     */
    CentreRays(Function<PathObserver, SampleTracer> tracerFor) {
        tracer = tracerFor.apply(this);
    }

    /** Begins with a sample of an eye, whose place on the lens and moment the rays through the centre share. */
    void begin(EyeView seeing, SamplePositions places, int sample) {
        eye = seeing;
        column = places.column(sample);
        row = places.row(sample);
        lensX = places.lensX(sample);
        lensY = places.lensY(sample);
        moment = places.moment(sample);
        known = false;
        next = 0;
    }

    /**
     * The ray that takes the place of the next one of the sample that leaves the scene; null if the centre of the pixel
     * sees something else.
     */
    Ray insteadOf(Ray ray) {
        if (!known) {
            known = true;
            leaving.clear();
            tracer.sample(eye, column + 0.5, row + 0.5, lensX, lensY, moment);
        }
        Ray found = next < leaving.size() ? leaving.get(next) : null;
        next++;
        return found != null && found.depth == ray.depth ? found : null;
    }

    /** The opening angle with which they have left the camera. */
    double spread() {
        return spread;
    }

    @Override
    public void starts(Ray ray) {
        spread = ray.spread;
    }

    @Override
    public void leaves(Frame frame, Ray ray) {
        if (frame == Frame.SCENE) {
            leaving.add(Ray.blank().set(ray));
        }
    }
}
