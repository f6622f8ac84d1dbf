package tompkins.trace;

import tompkins.camera.EyeView;
import tompkins.camera.SamplePositions;
import tompkins.ray.Colour;
import tompkins.ray.Padded;
import tompkins.ray.RayCounts;
import tompkins.ray.RayPacket;
import tompkins.studio.View;

/** Follows the rays of an eye's samples through what is on board, and then the scene. One for each thread. */
final class EyeTracer extends Padded {

    private final RenderPlan plan;
    private final RayTracer cameraTracer;
    private final SceneBehindCamera scene;
    private final StarTracer stars;
    private final RayCounts counts;
    private final RayPacket rays = new RayPacket(RayPacket.MOST);

    /** What each ray that leaves the camera frame has brought, and the part that arrives of the light of the scene. */
    private final Colour[] lights = new Colour[RayPacket.MOST];

    private final Colour[] throughputs = new Colour[RayPacket.MOST];
    private double narrowing = 1;
    private EyeView eye;
    private SamplePositions places;
    private int sample;

    /**
     * A tracer.
     *
     * @param cameraTracer the tracer of the camera frame, or null if no objects move with the camera
     * @param stars the stars behind the scene, or null if there are none
     */
    EyeTracer(RenderPlan plan, RayTracer cameraTracer, SceneBehindCamera scene, StarTracer stars, RayCounts counts) {
        this.plan = plan;
        this.cameraTracer = cameraTracer;
        this.scene = scene;
        this.stars = stars;
        this.counts = counts;
    }

    /** Multiplies the opening angles of rays from now on. */
    void narrow(double factor) {
        narrowing = factor;
    }

    /**
     * Follows the rays of all places in an eye's picture, as far as the taker lets it.
     *
     * @param into gets the colours; a sample without a ray is black
     * @param first the number of the sample of the first place
     * @return how many of the first samples are known
     */
    int follow(EyeView seeing, SamplePositions seen, BlockSamples into, int first, SampleSink taker) {
        eye = seeing;
        places = seen;
        sample = 0;
        plan.pictureRays().of(eye).make(places, rays, counts);
        scene.start(rays, plan.studio().view() == View.MEASURED);
        if (narrowing != 1) {
            rays.narrow(narrowing);
        }
        into.fill(first, first + places.count(), Colour.BLACK);
        if (cameraTracer != null && !followInCameraFrame(into, first, taker)) {
            return 0;
        }
        scene.begin(rays);
        for (int i = 0; i < rays.count(); i++) {
            if (!goesTo(i, taker)) {
                return sample;
            }
            Colour behind = scene.colour(rays, i);
            into.set(
                    first + sample,
                    finite(cameraTracer == null ? behind : lights[i].plus(throughputs[i].times(behind))));
        }
        return places.count();
    }

    /** Keeps the rays that leave what moves with the camera; false if the taker stops before all are followed. */
    private boolean followInCameraFrame(BlockSamples into, int first, SampleSink taker) {
        int leaving = 0;
        cameraTracer.begin(rays);
        for (int i = 0; i < rays.count(); i++) {
            if (!goesTo(i, taker)) {
                return false;
            }
            TracedPath path = cameraTracer.follow(rays, i);
            if (path.escaped() == null) {
                into.set(first + sample, finite(path.light()));
            } else {
                lights[leaving] = path.light();
                throughputs[leaving] = path.throughput();
                rays.move(i, leaving, path.escaped());
                leaving++;
            }
        }
        rays.keep(leaving);
        return true;
    }

    private boolean goesTo(int index, SampleSink taker) {
        sample = rays.sample(index);
        if (stars != null) {
            stars.begin(eye, places, sample);
        }
        return !taker.isStopped();
    }

    private Colour finite(Colour colour) {
        if (!colour.isFinite()) {
            counts.notFinite++;
            return Colour.BLACK;
        }
        return colour;
    }

    /** The column of the pixel of the ray that is followed. */
    int column() {
        return eye.column() + places.columns[sample];
    }

    /** The row of that pixel. */
    int row() {
        return eye.row() + places.rows[sample];
    }
}
