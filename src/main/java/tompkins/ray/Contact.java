package tompkins.ray;

import java.util.ArrayList;
import java.util.List;

/**
 * A place at which a ray meets several surfaces that touch, one after the other without a distance between, and the
 * layer of them at which the ray is. A layer is one surface, or several that act as one. Immutable.
 */
public final class Contact {

    /** Hits are at one place if they differ by no more than this, across the surface, relative to {@link #size}. */
    public static final double ROUNDING = 1e-13;

    /** The part of a boundary on which a ray does not start. */
    public static final int NOWHERE = Integer.MIN_VALUE;

    private final List<Hit> all;
    private final List<List<Hit>> layers;
    private final List<Hit> rivals;
    private final int layer;

    /** 1 on the way on which the place was found, -1 on the way back. */
    private final int way;

    private Contact(List<Hit> all, List<List<Hit>> layers, List<Hit> rivals, int layer, int way) {
        this.all = all;
        this.layers = layers;
        this.rivals = rivals;
        this.layer = layer;
        this.way = way;
    }

    /**
     * A place that a ray has reached.
     *
     * @param all the hits of that ray on all surfaces there
     * @param layers those that it meets, in this order; those of one layer act together
     * @param rivals opaque ones of which only the first is seen, because it is listed first
     */
    public static Contact of(List<Hit> all, List<List<Hit>> layers, List<Hit> rivals) {
        return new Contact(all, layers, rivals, -1, 1);
    }

    /** What rounding at a distance along a ray is compared with: a sum of lengths. */
    public static double size(Ray ray, double distance) {
        return Math.abs(ray.x) + Math.abs(ray.y) + Math.abs(ray.z) + distance;
    }

    /** The next layer on the way; null if there is none. */
    public Contact next() {
        int next = layer + way;
        return next < 0 || next >= layers.size() ? null : new Contact(all, layers, rivals, next, way);
    }

    /** The same layer for a ray that leaves it: through it, or back to where it has come from. */
    Contact leave(boolean through) {
        return through ? this : new Contact(all, layers, rivals, layer, -way);
    }

    /** The hits of this layer. */
    public List<Hit> hits() {
        return layers.get(layer);
    }

    /** Opaque surfaces here that differ, and of which only the first is seen. */
    public List<Hit> rivals() {
        return rivals;
    }

    /** The first hit of this layer, for a ray that comes along. */
    public Hit hit() {
        Hit hit = hits().get(0).copy();
        boolean arrives = way > 0 && layer == 0;
        hit.distance = arrives ? hit.distance : 0;
        hit.contact = this;
        return hit;
    }

    /** Hits of the layers through which the ray has come to this one. */
    public List<Hit> passed() {
        List<Hit> passed = new ArrayList<>();
        for (int i = layer - way; i >= 0 && i < layers.size(); i -= way) {
            passed.addAll(layers.get(i));
        }
        return passed;
    }

    /** The part of a boundary that is met here; {@link #NOWHERE} if none is. */
    int part(Boundary boundary) {
        for (Hit hit : all) {
            if (hit.boundary == boundary) {
                return hit.part;
            }
        }
        return NOWHERE;
    }
}
