package tompkins.shutter;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.RigidMotion;
import tompkins.math.Vectors;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.spacetime.SpaceTimeTransformation;

/**
 * A shutter in any plane of the camera frame: with a point Q and the normal n, the time at the lens is {@code t + (Q -
 * E).n / d.n} for a ray with the unit direction d. A ray that is parallel to the plane never crosses it.
 */
@Meaning("A shutter in any plane that moves with the camera")
public record ArbitraryPlaneShutter(
        @Meaning(value = "Time at which the shutter opens", unit = "time")
        double openingTime,

        @Meaning(value = "A point of the plane, in the camera frame", unit = "length")
        Vector3dc point,

        @Meaning("Direction of the plane's normal, of any length")
        Vector3dc normal)
        implements Shutter {

    /** A plane one unit in front of the camera. */
    public static final ArbitraryPlaneShutter DEFAULT =
            new ArbitraryPlaneShutter(-1, new Vector3d(0, 0, 1), new Vector3d(0, 0, 1));

    /** Checks all values. */
    public ArbitraryPlaneShutter {
        Require.coordinate("openingTime", openingTime);
        point = Require.position("point", point);
        normal = Require.direction("normal", normal);
    }

    @Override
    public double transmissionTime(LensRay ray, SpaceTimeTransformation sceneFromCamera) {
        Vector3d direction = ray.towardsFocus().normalize();
        Vector3d unit = Vectors.unit(normal);
        double slope = direction.dot(unit);
        double height = point.sub(ray.pupilPoint(), new Vector3d()).dot(unit);
        // parallel: not finite, whether or not the lens lies in the plane
        return slope == 0 ? Double.NaN : openingTime + height / slope;
    }

    @Override
    public Shutter moved(RigidMotion motion) {
        return new ArbitraryPlaneShutter(openingTime, motion.place(point), motion.direction(normal));
    }
}
