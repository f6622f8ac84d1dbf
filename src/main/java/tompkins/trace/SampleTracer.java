package tompkins.trace;

import java.util.List;
import java.util.stream.IntStream;
import tompkins.camera.EyeView;
import tompkins.camera.PictureRays;
import tompkins.camera.SamplePositions;
import tompkins.camera.Sampler;
import tompkins.ray.Colour;
import tompkins.ray.Medium;
import tompkins.ray.Padded;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.ray.RayPacket;

/** Takes samples of a picture. One for each thread. */
public final class SampleTracer extends Padded {

    /**
     * Columns of the places on Morton's way through the block, on which those that follow each other are neighbours;
     * the row of a place is the column of half its number.
     */
    private static final int[] MORTON_COLUMNS =
            IntStream.range(0, RayPacket.MOST).map(SampleTracer::mortonColumn).toArray();

    private final Sampler sampler;
    private final PictureRays pictureRays;
    private final int cameraFrame;
    private final Medium lensMedium;
    private final MovingMedium sceneMedium;
    private final boolean measures;
    private final RayTracer cameraTracer;
    private final SceneBehindCamera sceneBehindCamera;
    private final StarTracer stars;
    private final RayCounts counts;
    private final PathObserver observer;

    /** The samples that each eye takes. */
    private final List<SamplePositions> placesOfEyes;

    private final RayPacket rays = new RayPacket(RayPacket.MOST);

    /** The eye whose picture the places are in. */
    private EyeView eye;

    private SamplePositions places;

    /** The samples of the block; those of the second eye follow those of the first. */
    private final BlockSamples samples = new BlockSamples();

    /** The number of the first one of the eye. */
    private int first;

    /** Of an anaglyph the light of the left eye, while the right one is traced for the same pixels. */
    private final Colour[] leftLight = new Colour[RayPacket.MOST];

    private final Colour[] sums = new Colour[RayPacket.MOST];
    private final Colour[] factors = new Colour[RayPacket.MOST];
    private double narrowing = 1;
    private int column;
    private int row;

    /**
     * A tracer.
     *
     * @param cameraFrame the number of the camera frame
     * @param lensMedium a medium in which the lens rests; may be null
     * @param sceneMedium a medium of the scene through which the lens moves; may be null
     * @param measures whether to measure where things are, instead of following light
     * @param cameraTracer the tracer of the camera frame, or null if no objects move with the camera
     * @param stars the stars behind the scene, or null if there are none
     * @param observer watches the rays; may be null
     */
    SampleTracer(
            Sampler sampler,
            PictureRays pictureRays,
            int cameraFrame,
            Medium lensMedium,
            MovingMedium sceneMedium,
            boolean measures,
            RayTracer cameraTracer,
            SceneBehindCamera sceneBehindCamera,
            StarTracer stars,
            RayCounts counts,
            PathObserver observer) {
        this.sampler = sampler;
        this.pictureRays = pictureRays;
        placesOfEyes = pictureRays.views().stream()
                .map(view -> new SamplePositions(RayPacket.MOST))
                .toList();
        this.cameraFrame = cameraFrame;
        this.lensMedium = lensMedium;
        this.sceneMedium = sceneMedium;
        this.measures = measures;
        this.cameraTracer = cameraTracer;
        this.sceneBehindCamera = sceneBehindCamera;
        this.stars = stars;
        this.counts = counts;
        this.observer = observer;
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
        narrowing = Math.pow(samples, -0.75);
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
        places = placesOfEyes.get(pictureRays.views().indexOf(next));
    }

    private void start() {
        pictureRays.of(eye).make(places, rays, counts);
        rays.inFrame(cameraFrame);
        if (observer != null && rays.count() > 0) {
            observer.starts(rays.ray(0));
        }
        if (measures) {
            rays.measure();
        } else if (lensMedium != null) {
            rays.startIn(lensMedium.index());
            rays.in(sceneBehindCamera.sceneTracer().keepsMedia() ? lensMedium : null);
        } else if (sceneMedium != null) {
            sceneMedium.begin(rays);
        }
        if (narrowing != 1) {
            rays.narrow(narrowing);
        }
    }

    /**
     * The colour at the only place. An observer of an anaglyph watches the ray of the left eye, and gets its colour.
     */
    private Colour single() {
        counts.samples++;
        Colour colour = ofEye();
        if (observer != null || !pictureRays.layout().isAnaglyph()) {
            return colour;
        }
        eye = pictureRays.views().get(1);
        return pictureRays.layout().combined(colour, ofEye());
    }

    private Colour ofEye() {
        start();
        if (rays.count() == 0) {
            return Colour.BLACK;
        }
        Ray ray = rays.ray(0);
        if (stars != null) {
            stars.begin(eye, places, 0);
        }
        return finite(cameraTracer == null ? sceneBehindCamera.colour(ray) : cameraTracer.colourOf(ray));
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
        column = left;
        row = top;
        samples.clear();
        for (EyeView next : eyes()) {
            begin(next);
            addPixels(left, top, width, height, stride, taker);
        }
    }

    /** The eyes that have places of their own. */
    private List<EyeView> eyes() {
        List<EyeView> all = pictureRays.views();
        return pictureRays.layout().isAnaglyph() ? all.subList(0, 1) : all;
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
        first = 0;
        for (EyeView next : eyes()) {
            turnTo(next);
            sampler.choose(places, sample);
            int known = trace(taker);
            if (pictureRays.layout().isAnaglyph()) {
                known = known < places.count()
                        ? 0
                        : combineWith(pictureRays.views().get(1), taker);
            }
            first += known;
            if (known < places.count()) {
                break;
            }
        }
        counts.samples += first;
        samples.setCount(first);
        taker.take(samples);
    }

    /** Begins a block, as above, and takes one sample of each of its pixels. */
    public void sampleBlock(int left, int top, int width, int height, int stride, int sample, SampleSink taker) {
        beginBlock(left, top, width, height, stride, taker);
        sampleBlock(sample, taker);
    }

    /** Follows the rays of another eye for the same places, and combines the colours of both. */
    private int combineWith(EyeView right, SampleSink taker) {
        for (int i = 0; i < places.count(); i++) {
            leftLight[i] = samples.colour(i);
        }
        eye = right;
        int known = trace(taker);
        for (int i = 0; i < known; i++) {
            samples.set(i, pictureRays.layout().combined(leftLight[i], samples.colour(i)));
        }
        return known;
    }

    /** Follows the rays of all places, as far as the taker lets it; returns how many of the first samples are known. */
    private int trace(SampleSink taker) {
        start();
        boolean allGoOn = rays.count() == places.count() && cameraTracer == null;
        Colour behind = allGoOn ? sceneBehindCamera.evenBackground() : null;
        // a sample without a ray is black
        samples.fill(first, first + places.count(), behind == null ? Colour.BLACK : behind);
        if (cameraTracer != null && !followInCameraFrame(taker)) {
            return 0;
        }
        int followed = 0;
        if (rays.isInOneMedium()) {
            followed = followInScene(behind != null, taker);
        } else {
            for (; followed < rays.count() && goesTo(followed, taker); followed++) {
                takeFromScene(followed, sceneBehindCamera.colour(rays.ray(followed)));
            }
        }
        return followed < rays.count() ? rays.sample(followed) : places.count();
    }

    /** Keeps the rays that leave what moves with the camera; false if the taker stops before all are followed. */
    private boolean followInCameraFrame(SampleSink taker) {
        int leaving = 0;
        cameraTracer.begin(rays);
        for (int i = 0; i < rays.count(); i++) {
            if (!goesTo(i, taker)) {
                return false;
            }
            TracedPath path = cameraTracer.follow(rays, i);
            if (path.escaped() == null) {
                take(i, path.light());
            } else {
                sums[leaving] = path.light();
                factors[leaving] = path.throughput();
                rays.move(i, leaving, path.escaped());
                leaving++;
            }
        }
        rays.keep(leaving);
        return true;
    }

    /**
     * Follows the rays through the scene.
     *
     * @param known whether the samples have the light of rays that meet nothing
     * @return how many were followed before the taker stopped
     */
    private int followInScene(boolean known, SampleSink taker) {
        RayTracer tracer = sceneBehindCamera.sceneTracer();
        sceneBehindCamera.enter(rays);
        tracer.begin(rays);
        for (int i = 0; i < rays.count(); i++) {
            if (known && !tracer.mayMeet(i)) {
                counts.rays++;
                continue;
            }
            if (!goesTo(i, taker)) {
                return i;
            }
            // light without a direction is at rest in the scene, and has come from nowhere
            Colour light = Double.isNaN(rays.dx[i]) ? Colour.BLACK : tracer.packetColour(rays, i);
            takeFromScene(i, sceneBehindCamera.inCameraFrame(light, rays.frequency[i], rays.directionLength[i]));
        }
        return rays.count();
    }

    private void addPixels(int left, int top, int width, int height, int stride, SampleSink taker) {
        // the way goes through a square of twice the side only after the smaller one
        int side = Integer.highestOneBit(2 * ((Math.max(width, height) - 1) / stride) + 1);
        for (int place = 0; place < side * side; place++) {
            int across = stride * MORTON_COLUMNS[place];
            int down = stride * MORTON_COLUMNS[place >> 1];
            int nextColumn = left + across;
            int nextRow = top + down;
            if (across < width
                    && down < height
                    && taker.wants(nextColumn, nextRow)
                    && pictureRays.view(nextColumn, nextRow) == eye) {
                places.addPixel(nextColumn - eye.column(), nextRow - eye.row());
                samples.add(nextColumn, nextRow);
            }
        }
    }

    private static int mortonColumn(int place) {
        return place & 1 | place >> 1 & 2 | place >> 2 & 4 | place >> 3 & 8;
    }

    private boolean goesTo(int index, SampleSink taker) {
        int sample = rays.sample(index);
        column = eye.column() + places.column(sample);
        row = eye.row() + places.row(sample);
        if (stars != null) {
            stars.begin(eye, places, sample);
        }
        return !taker.isStopped();
    }

    private void takeFromScene(int index, Colour colour) {
        take(index, cameraTracer == null ? colour : sums[index].plus(factors[index].times(colour)));
    }

    private void take(int index, Colour colour) {
        samples.set(first + rays.sample(index), finite(colour));
    }

    private Colour finite(Colour colour) {
        if (!colour.isFinite()) {
            counts.notFinite++;
            return Colour.BLACK;
        }
        return colour;
    }

    /** The column of the pixel at which this tracer is at work, for reports of failures. */
    public int column() {
        return column;
    }

    /** The row of the pixel at which this tracer is at work. */
    public int row() {
        return row;
    }
}
