package tompkins.trace;

import java.util.function.BooleanSupplier;
import tompkins.camera.EyeView;
import tompkins.camera.SamplePositions;
import tompkins.camera.Sampler;
import tompkins.ray.Colour;
import tompkins.ray.Padded;
import tompkins.ray.RayCounts;
import tompkins.ray.RayPacket;
import tompkins.studio.View;

/** Takes samples of a picture: follows their rays through what is on board, and then the scene. One for each thread. */
public final class SampleTracer extends Padded {

    private final RenderPlan plan;
    private final Sampler sampler;
    private final RayTracer cameraTracer;
    private final SceneBehindCamera scene;
    private final StarTracer stars;
    private final RayCounts counts;

    private final BlockSamples samples = new BlockSamples();

    /** What the right eye sees at the places of these; null if each eye has places of its own. */
    private final BlockSamples samplesOfRight;

    private final SamplePositions single = new SamplePositions(1);
    private final RayPacket rays = new RayPacket(RayPacket.MOST);

    /** What each ray that leaves the camera frame has brought, and the part that arrives of the light of the scene. */
    private final Colour[] lights = new Colour[RayPacket.MOST];

    private final Colour[] throughputs = new Colour[RayPacket.MOST];
    private double narrowing = 1;

    // the sample that is being followed
    private EyeView eye;
    private SamplePositions places;
    private int sample;

    /**
     * A tracer; who watches an anaglyph sees the rays of the left eye alone.
     *
     * @param cameraTracer the tracer of the camera frame, or null if no objects move with the camera
     * @param stars the stars behind the scene, or null if there are none
     */
    SampleTracer(
            RenderPlan plan,
            Sampler sampler,
            RayTracer cameraTracer,
            SceneBehindCamera scene,
            StarTracer stars,
            RayCounts counts) {
        this.plan = plan;
        this.sampler = sampler;
        this.cameraTracer = cameraTracer;
        this.scene = scene;
        this.stars = stars;
        this.counts = counts;
        samplesOfRight = plan.pictureRays().layout().isAnaglyph() && !scene.isWatched() ? new BlockSamples() : null;
    }

    /**
     * Sets how many samples a pixel gets from now on; it starts with 1. Each stands for a part of the pixel: fine
     * detail must not be blurred twice, by the width of a ray and by the mean over several. The part shrinks like
     * samples^-0.75, as the error at an edge does (docs/speed-and-accuracy.md, aperture): so the blur by the width of
     * rays, which no difference between samples shows, stays below the error of the samples.
     *
     * @param number 1 or more
     */
    public void shareBetween(int number) {
        narrowing = Math.pow(number, -0.75);
    }

    /** The colour of one sample of a pixel, before exposure. Black where something went wrong, which is counted. */
    public Colour sample(int pixelColumn, int pixelRow, int number) {
        EyeView seeing = plan.pictureRays().view(pixelColumn, pixelRow);
        single.begin(seeing);
        single.addPixel(pixelColumn - seeing.column(), pixelRow - seeing.row());
        return sampleBlock(single, number, () -> false).colour(0);
    }

    /**
     * The colour that a point of the picture, in pixels, gets through a point of the lens, in units of its radius.
     *
     * @param moment the part of the exposure time that has passed, from 0 to 1
     */
    public Colour sample(double x, double y, double lensX, double lensY, double moment) {
        EyeView seeing = plan.pictureRays().view(x, y);
        single.begin(seeing);
        single.add(x - seeing.column(), y - seeing.row(), lensX, lensY, moment);
        return follow(single, () -> false).colour(0);
    }

    /** Takes a sample of an eye's picture at another place (x, y) in its pixels. */
    void sampleBeside(EyeView seeing, SamplePositions others, int index, double x, double y) {
        single.begin(seeing);
        single.addBeside(others, index, x, y);
        follow(single, () -> false);
    }

    /**
     * Takes one sample of each of some pixels. All rays are made first and followed through what moves with the camera.
     * For those that leave it, the few objects that they can meet are found at once, or else, for a few neighbours at a
     * time, where they enter the tree. The colours are those of single samples.
     *
     * @param pixels at most {@link RayPacket#MOST}; gets the positions
     * @param number the number of the sample, the same for each pixel
     * @param stopped whether no sample is wanted any more; asked before a ray is followed in each frame
     * @return memory that is used again for the next block; null if it was stopped
     */
    public BlockSamples sampleBlock(SamplePositions pixels, int number, BooleanSupplier stopped) {
        sampler.choose(pixels, number);
        return follow(pixels, stopped);
    }

    private BlockSamples follow(SamplePositions seen, BooleanSupplier stopped) {
        places = seen;
        if (!follows(seen.eye(), samples, stopped)) {
            return null;
        }
        if (samplesOfRight != null) {
            if (!follows(plan.pictureRays().views().get(1), samplesOfRight, stopped)) {
                return null;
            }
            samples.combine(plan.pictureRays().layout(), samplesOfRight, seen.count());
        }
        counts.samples += seen.count();
        return samples;
    }

    /** Follows the rays of all places through the lens of an eye; a sample without a ray is black. */
    private boolean follows(EyeView seeing, BlockSamples into, BooleanSupplier stopped) {
        eye = seeing;
        sample = 0;
        eye.rays().make(places, rays, counts);
        scene.start(rays, plan.studio().view() == View.MEASURED);
        rays.narrow(narrowing);
        Colour even = cameraTracer == null && rays.count() == places.count() ? scene.evenBackground() : null;
        into.fill(places.count(), even == null ? Colour.BLACK : even);
        if (cameraTracer != null && !followInCameraFrame(into, stopped)) {
            return false;
        }
        scene.begin(rays);
        for (int i = 0; i < rays.count(); i++) {
            if (even != null && !scene.mayMeet(i)) {
                counts.rays++;
                continue;
            }
            if (!goesTo(i, stopped)) {
                return false;
            }
            Colour behind = scene.colour(rays, i);
            into.set(
                    sample,
                    counts.finite(cameraTracer == null ? behind : lights[i].plus(throughputs[i].times(behind))));
        }
        return true;
    }

    /** Keeps the rays that leave what moves with the camera; false if it was stopped before all are followed. */
    private boolean followInCameraFrame(BlockSamples into, BooleanSupplier stopped) {
        int leaving = 0;
        cameraTracer.begin(rays);
        for (int i = 0; i < rays.count(); i++) {
            if (!goesTo(i, stopped)) {
                return false;
            }
            TracedPath path = cameraTracer.follow(rays, i);
            if (path.escaped() == null) {
                into.set(sample, counts.finite(path.light()));
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

    private boolean goesTo(int index, BooleanSupplier stopped) {
        sample = rays.sample(index);
        if (stars != null) {
            stars.begin(eye, places, sample);
        }
        return !stopped.getAsBoolean();
    }

    /** The column of the pixel at which this tracer is at work, for reports of failures. */
    public int column() {
        return places.column(sample);
    }

    /** The row of the pixel at which this tracer is at work. */
    public int row() {
        return places.row(sample);
    }
}
