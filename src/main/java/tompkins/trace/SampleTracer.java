package tompkins.trace;

import java.util.List;
import tompkins.camera.EyeView;
import tompkins.camera.PictureRays;
import tompkins.camera.SamplePositions;
import tompkins.camera.Sampler;
import tompkins.ray.Colour;
import tompkins.ray.Padded;
import tompkins.ray.RayCounts;
import tompkins.ray.RayPacket;

/** Takes samples of a picture. One for each thread. */
public final class SampleTracer extends Padded {

    /** Gets single samples. */
    private static final SampleSink NOBODY = samples -> {};

    private final PictureRays pictureRays;
    private final Sampler sampler;
    private final EyeTracer tracer;
    private final RayCounts counts;

    /** The samples that each eye takes; those of both eyes of an anaglyph lie at the same places. */
    private final List<SamplePositions> placesOfEyes;

    /** The eyes that have places of their own. */
    private final List<EyeView> eyes;

    /** The eye that sees the same places; null if there is none. */
    private final EyeView other;

    /** The samples of the block; those of the second eye follow those of the first. */
    private final BlockSamples samples = new BlockSamples();

    /** What the other eye sees at the places of these; null if there is none. */
    private final BlockSamples samplesOfOther;

    /** The eye whose picture the places are in. */
    private EyeView eye;

    private SamplePositions places;

    /** A tracer; who watches an anaglyph sees the rays of the left eye alone. */
    SampleTracer(PictureRays pictureRays, Sampler sampler, EyeTracer tracer, RayCounts counts, boolean isWatched) {
        this.pictureRays = pictureRays;
        this.sampler = sampler;
        this.tracer = tracer;
        this.counts = counts;
        List<EyeView> views = pictureRays.views();
        boolean sharePlaces = pictureRays.layout().isAnaglyph();
        eyes = sharePlaces ? views.subList(0, 1) : views;
        other = sharePlaces && !isWatched ? views.get(1) : null;
        samplesOfOther = other == null ? null : new BlockSamples();
        placesOfEyes =
                eyes.stream().map(view -> new SamplePositions(RayPacket.MOST)).toList();
    }

    /**
     * Sets how many samples a pixel gets from now on; it starts with 1. Each stands for a part of the pixel, so that
     * fine detail is not blurred twice, by the width of a ray and by the mean over several rays. The part shrinks like
     * samples^-0.75, as the error of the sampler at an edge does (see the charts of aperture in
     * docs/speed-and-accuracy.md): the blur by the width of rays, which no difference between samples shows, stays
     * below the error of the samples.
     *
     * @param samples 1 or more
     */
    public void shareBetween(int samples) {
        tracer.narrow(Math.pow(samples, -0.75));
    }

    /** The colour of one sample of a pixel, before exposure. Black where something went wrong, which is counted. */
    public Colour sample(int pixelColumn, int pixelRow, int sample) {
        begin(pictureRays.view(pixelColumn, pixelRow));
        places.addPixel(pixelColumn - eye.column(), pixelRow - eye.row());
        sampler.choose(places, sample);
        return single();
    }

    /**
     * The colour that a point of the picture gets through a point of the lens at a moment.
     *
     * @param x place in the picture in pixels
     * @param y place in the picture in pixels
     * @param lensX place on the lens in units of its radius
     * @param lensY place on the lens in units of its radius
     * @param moment the part of the exposure time that has passed, from 0 to 1
     */
    public Colour sample(double x, double y, double lensX, double lensY, double moment) {
        begin(pictureRays.view(x, y));
        places.add(x - eye.column(), y - eye.row(), lensX, lensY, moment);
        return single();
    }

    /** Takes a sample of an eye's picture at another place (x, y) in its pixels. */
    void sampleBeside(EyeView seeing, SamplePositions others, int sample, double x, double y) {
        begin(seeing);
        places.addBeside(others, sample, x, y);
        single();
    }

    private void begin(EyeView next) {
        turnTo(next);
        places.clear();
    }

    private void turnTo(EyeView next) {
        eye = next;
        places = placesOfEyes.get(Math.min(pictureRays.number(next), eyes.size() - 1));
    }

    private Colour single() {
        counts.samples += follow(0, NOBODY);
        return samples.colour(0);
    }

    /**
     * Begins a block of pixels, to take samples of them by {@link #sampleBlock}.
     *
     * @param left first column
     * @param top first row
     * @param width columns of the block
     * @param height rows of the block
     * @param stride distance between the pixels that are sampled; at most {@link RayPacket#SIDE} of them each way
     * @param taker says which pixels are wanted
     */
    public void beginBlock(int left, int top, int width, int height, int stride, SampleSink taker) {
        samples.clear();
        for (EyeView next : eyes) {
            begin(next);
            // the way goes through a square of twice the side only after the smaller one
            int side = Integer.highestOneBit(2 * ((Math.max(width, height) - 1) / stride) + 1);
            for (int index = 0; index < side * side; index++) {
                int across = stride * BlockSamples.across(index);
                int down = stride * BlockSamples.down(index);
                if (across < width && down < height) {
                    addPixel(left + across, top + down, taker);
                }
            }
        }
    }

    private void addPixel(int x, int y, SampleSink taker) {
        if (pictureRays.view(x, y) == eye && taker.wants(x, y)) {
            places.addPixel(x - eye.column(), y - eye.row());
            samples.add(x, y);
        }
    }

    /**
     * Takes one sample of each pixel of the block. All rays of the block are made first and followed through what moves
     * with the camera. For those that leave it, the few objects that they can meet are found at once, or else, for a
     * few neighbours at a time, where they enter the tree. The colours are those of single samples.
     *
     * @param sample number of the sample of each pixel
     * @param taker gets the colours: of the first pixels alone if it stops before all are known
     */
    public void sampleBlock(int sample, SampleSink taker) {
        int known = 0;
        for (EyeView next : eyes) {
            turnTo(next);
            sampler.choose(places, sample);
            int ofEye = follow(known, taker);
            known += ofEye;
            if (ofEye < places.count()) {
                break;
            }
        }
        counts.samples += known;
        samples.setCount(known);
        taker.take(samples);
    }

    /** Follows the rays of all places, as far as the taker lets it; returns how many of the first samples are known. */
    private int follow(int first, SampleSink taker) {
        int known = tracer.follow(eye, places, samples, first, taker);
        if (other != null) {
            known = Math.min(known, tracer.follow(other, places, samplesOfOther, 0, taker));
            samples.combine(pictureRays.layout(), samplesOfOther, known);
        }
        return known;
    }

    /** The column of the pixel at which this tracer is at work, for reports of failures. */
    public int column() {
        return tracer.column();
    }

    /** The row of the pixel at which this tracer is at work. */
    public int row() {
        return tracer.row();
    }
}
