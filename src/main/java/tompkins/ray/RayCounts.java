package tompkins.ray;

/**
 * Counts what happened to the rays of one thread. What goes wrong leaves no mark in the picture; it is counted here.
 */
public final class RayCounts extends Padded {

    private static final double PARTS = 0x1p32;

    /** Samples that were taken, without those that a block left out because it was stopped. */
    public long samples;

    /** Rays that were followed; one that leaves what moves with the camera counts once per frame. */
    public long rays;

    /** Tests whether a light is visible. */
    public long shadowRays;

    /** Nodes of bounding-volume trees that were visited. */
    public long nodes;

    /** Primitives that were tested. */
    public long tests;

    /** How often a ray among the objects of the scene met the first of them on its way. */
    public long sceneHits;

    /** Samples whose chief ray misses the surface on which the camera is focused; they were focused at infinity. */
    public long withoutFocus;

    /** Samples that never cross the shutter, or only at infinity; they stayed black. */
    public long withoutShutter;

    /** Samples whose colour was not a number that a picture can hold; they stayed black. */
    public long notFinite;

    /** Rays that were ended because they had met too many surfaces. */
    public long tooDeep;

    /** Rays that were ended because they could bring less than {@link Ray#FAINTEST} of the light. */
    public long tooFaint;

    /** The most light that those could have brought, in parts of a sample: a whole number adds up in any order. */
    private long lostParts;

    /** The colour of a sample; black, which is counted, where something went wrong. */
    public Colour finite(Colour colour) {
        if (!colour.isFinite()) {
            notFinite++;
            return Colour.BLACK;
        }
        return colour;
    }

    /** Counts a ray that is ended because it could bring no more than a fraction of the light of its sample. */
    public void giveUp(double fraction) {
        tooFaint++;
        lostParts += (long) (fraction * PARTS);
    }

    /** The sum of the largest fractions that rays which were too faint could have brought to their samples. */
    public double lostLight() {
        return lostParts / PARTS;
    }

    /** Adds the counts of another thread. */
    public void add(RayCounts other) {
        samples += other.samples;
        rays += other.rays;
        shadowRays += other.shadowRays;
        nodes += other.nodes;
        tests += other.tests;
        sceneHits += other.sceneHits;
        withoutFocus += other.withoutFocus;
        withoutShutter += other.withoutShutter;
        notFinite += other.notFinite;
        tooDeep += other.tooDeep;
        tooFaint += other.tooFaint;
        lostParts += other.lostParts;
    }
}
