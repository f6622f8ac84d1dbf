package tompkins.shutter;

import org.joml.Vector3d;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.spacetime.SpaceTimeTransformation;

/**
 * A shutter at the detector behind a phase hologram of a lens, which is thin and does not delay light: the time is
 * {@code t - |PE|}, with the distance from the detector point P to the pupil point E.
 */
@Meaning("A shutter at the detector, behind a hologram of a lens, which does not delay light")
public record LensHologramShutter(
        @Meaning(value = "Time at which the shutter opens", unit = "time")
        double openingTime,

        @Meaning(value = "Distance of the detector behind the lens", unit = "length")
        double detectorDistance)
        implements Shutter {

    /** Opens at time 1 at unit distance. */
    public static final LensHologramShutter DEFAULT = new LensHologramShutter(1, 1);

    /** Checks both values. */
    public LensHologramShutter {
        Require.coordinate("openingTime", openingTime);
        Require.distance("detectorDistance", detectorDistance);
    }

    @Override
    public double transmissionTime(LensRay ray, SpaceTimeTransformation sceneFromCamera) {
        Vector3d fromDetector = new Vector3d(ray.chiefDirection())
                .mul(ray.detectorPointDistance(detectorDistance))
                .add(ray.offset());
        return openingTime - fromDetector.length();
    }
}
