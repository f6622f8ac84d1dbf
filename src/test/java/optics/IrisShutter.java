package optics;

import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.shutter.AddedShutter;
import tompkins.shutter.LensRay;
import tompkins.spacetime.SpaceTimeTransformation;

/** An iris in the aperture that opens from its centre. */
@Meaning("An iris in the plane of the aperture that opens from its centre")
public record IrisShutter(
        @Meaning(value = "Time at which the centre opens", unit = "time")
        double openingTime,

        @Meaning("Time by which a point opens later that lies one scene unit farther out, 0 or more")
        double delay)
        implements AddedShutter {

    /** Opens in a tenth of a time unit for each scene unit. */
    public static final IrisShutter DEFAULT = new IrisShutter();

    /** The usual iris. */
    public IrisShutter() {
        this(0, 0.1);
    }

    /** Checks the times. */
    public IrisShutter {
        Require.coordinate("openingTime", openingTime);
        Require.within("delay", delay, 0, 1e6);
    }

    @Override
    public double transmissionTime(LensRay ray, SpaceTimeTransformation sceneFromCamera) {
        return openingTime + delay * ray.offset().length();
    }
}
