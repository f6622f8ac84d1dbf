package tompkins.surface;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/** Snell's law as in the textbooks: the refracted ray as a difference of two nearly equal cosines. */
public final class NaiveRefraction {

    private NaiveRefraction() {}

    /** {@code eta d + (eta c - c') n}, or the mirrored direction. */
    public static Vector3d bend(Vector3dc d, Vector3dc normal, double before, double behind) {
        double along = d.dot(normal);
        double side = along > 0 ? -1 : 1;
        double cosine = Math.abs(along);
        double eta = before / behind;
        double squared = 1 - eta * eta * (1 - cosine * cosine);
        if (squared <= 0) {
            return new Vector3d(normal).mul(-2 * along).add(d);
        }
        return new Vector3d(d).mul(eta).add(new Vector3d(normal).mul(side * (eta * cosine - Math.sqrt(squared))));
    }
}
