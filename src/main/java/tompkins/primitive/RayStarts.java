package tompkins.primitive;

import tompkins.ray.Padded;
import tompkins.ray.RayPacket;

/** Where rays start. One for each thread, measured again for every packet. */
public final class RayStarts extends Padded {

    private boolean one;
    private double farthest;

    /** Looks at the rays of a packet from one place (included) to another (excluded). */
    public void measure(RayPacket rays, int from, int to) {
        double firstX = rays.x[from];
        double firstY = rays.y[from];
        double firstZ = rays.z[from];
        one = true;
        farthest = Math.abs(firstX) + Math.abs(firstY) + Math.abs(firstZ);
        for (int i = from + 1; i < to; i++) {
            double x = rays.x[i];
            double y = rays.y[i];
            double z = rays.z[i];
            if (x != firstX || y != firstY || z != firstZ) {
                one = false;
                farthest = Math.max(farthest, Math.abs(x) + Math.abs(y) + Math.abs(z));
            }
        }
    }

    /** Whether all rays start at one point, as most of those from a pinhole do. */
    public boolean areOne() {
        return one;
    }

    /** The largest |x| + |y| + |z| of a start. */
    public double farthest() {
        return farthest;
    }
}
