package tompkins.shutter;

import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.spacetime.SpaceTimeTransformation;

/** A shutter in the lens: all light crosses the lens at the same time. */
@Meaning("A shutter in the plane of the aperture: all light crosses the lens at the same time")
public record AperturePlaneShutter(
        @Meaning(value = "Time at which the shutter opens", unit = "time")
        double openingTime) implements Shutter {

    /** Opens at time 0. */
    public static final AperturePlaneShutter DEFAULT = new AperturePlaneShutter(0);

    /** Checks the time. */
    public AperturePlaneShutter {
        Require.coordinate("openingTime", openingTime);
    }

    @Override
    public double transmissionTime(LensRay ray, SpaceTimeTransformation sceneFromCamera) {
        return openingTime;
    }
}
