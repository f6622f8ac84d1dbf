package tompkins.shutter;

import org.joml.Vector3d;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.spacetime.SpaceTimeTransformation;

/**
 * A shutter at the detector behind an ideal lens, as in an electronic camera: all light reaches the detector at the
 * same time. The ideal lens delays the light so that all ways from a point to its image take equally long; the delay is
 * zero in the centre.
 *
 * <p>With the distances |PC| from the detector point to the lens centre, |CI| and |EI|, the time is {@code t - |PC| -
 * (|CI| - |EI|)} for a point in front, and with the opposite sign of the bracket for one behind. Both are {@code t -
 * |PC| - (1 - |D|)/w}, and the quotient is {@code (2 m.r - w r^2)/(1 + |D|)}, where nothing cancels and nothing is
 * infinite.
 */
@Meaning("A shutter at the detector, behind an ideal lens that delays light so that images stay sharp in motion")
public record DetectorPlaneShutter(
        @Meaning(value = "Time at which the shutter opens", unit = "time")
        double openingTime,

        @Meaning(value = "Distance of the detector behind the lens", unit = "length")
        double detectorDistance)
        implements Shutter {

    /** Opens at time 1 at unit distance, so that light crosses the centre of the lens about time 0. */
    public static final DetectorPlaneShutter DEFAULT = new DetectorPlaneShutter(1, 1);

    /** Checks both values. */
    public DetectorPlaneShutter {
        Require.coordinate("openingTime", openingTime);
        Require.distance("detectorDistance", detectorDistance);
    }

    @Override
    public double transmissionTime(LensRay ray, SpaceTimeTransformation sceneFromCamera) {
        Vector3d offset = ray.offset();
        double delay = (2 * offset.dot(ray.chiefDirection()) - ray.inverseFocusDistance() * offset.lengthSquared())
                / (1 + ray.towardsFocus().length());
        return openingTime - ray.detectorPointDistance(detectorDistance) - delay;
    }
}
