package tompkins.search;

import java.util.SplittableRandom;
import org.joml.Vector3d;
import tompkins.primitive.Bounds;
import tompkins.primitive.Primitive;

/** Random places to start rays from and to aim them at; the same ones for the same seed. */
public final class RandomAims {

    private final SplittableRandom random;

    public RandomAims(long seed) {
        random = new SplittableRandom(seed);
    }

    /** A number between two others. */
    public double mix(double low, double high) {
        return low + (high - low) * random.nextDouble();
    }

    /** A vector with coordinates up to the reach. */
    public Vector3d vector(double reach) {
        return new Vector3d(mix(-reach, reach), mix(-reach, reach), mix(-reach, reach));
    }

    /** A place in the box round a primitive, or anywhere near the origin if it has none. */
    public Vector3d placeIn(Primitive primitive) {
        Bounds bounds = primitive.bounds();
        return bounds == null
                ? vector(10)
                : new Vector3d(
                        mix(bounds.minX(), bounds.maxX()),
                        mix(bounds.minY(), bounds.maxY()),
                        mix(bounds.minZ(), bounds.maxZ()));
    }
}
