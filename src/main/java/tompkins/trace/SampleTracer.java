package tompkins.trace;

import java.util.List;
import tompkins.camera.CameraRays;
import tompkins.camera.PixelSampler;
import tompkins.ray.Colour;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.sceneobject.NearestHit;
import tompkins.studio.RenderSettings;

/** Takes single samples of a picture. One for each thread. */
public final class SampleTracer {

    private final PixelSampler sampler;
    private final CameraRays cameraRays;
    private final Beyond first;
    private final RayCounts counts;
    private final RayWitness witness;
    private final List<NearestHit> work;

    SampleTracer(
            RenderSettings settings,
            CameraRays cameraRays,
            Beyond first,
            RayCounts counts,
            RayWitness witness,
            List<NearestHit> work) {
        this.sampler = new PixelSampler(settings.seed(), settings.samples());
        this.cameraRays = cameraRays;
        this.first = first;
        this.counts = counts;
        this.witness = witness;
        this.work = work;
    }

    /** The colour of one sample of a pixel, before exposure. Black where something went wrong, which is counted. */
    public Colour sample(int column, int row, int sample) {
        sampler.start(column, row, sample);
        return sample(sampler.x(), sampler.y(), sampler.lensX(), sampler.lensY());
    }

    /**
     * The colour that a point of the picture gets through a point of the lens.
     *
     * @param x place in the picture in pixels
     * @param y place in the picture in pixels
     * @param lensX place on the lens in units of its radius
     * @param lensY place on the lens in units of its radius
     */
    public Colour sample(double x, double y, double lensX, double lensY) {
        counts.samples++;
        Ray ray = cameraRays.ray(x, y, lensX, lensY, counts);
        if (ray == null) {
            return Colour.BLACK;
        }
        if (witness != null) {
            witness.starts(ray);
        }
        Colour colour = first.colour(ray);
        if (!colour.isFinite()) {
            counts.notFinite++;
            return Colour.BLACK;
        }
        return colour;
    }

    /** Nodes of trees that this tracer visited. */
    public long nodes() {
        return work.stream().mapToLong(NearestHit::nodes).sum();
    }

    /** Tests of primitives in trees and lists that this tracer made. */
    public long tests() {
        return work.stream().mapToLong(NearestHit::tests).sum();
    }
}
