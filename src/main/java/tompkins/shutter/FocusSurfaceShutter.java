package tompkins.shutter;

import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.spacetime.SpaceTimeTransformation;

/**
 * A shutter on the surface on which the camera is focused: the light of all its points leaves at the same time of the
 * camera frame. The time at the lens is later by the signed distance to the point: {@code t + |D|/w}.
 */
@Meaning("A shutter on the surface that is in focus: light leaves all its points at the same camera time")
public record FocusSurfaceShutter(
        @Meaning(value = "Time at which the shutter opens", unit = "time")
        double openingTime) implements Shutter {

    /** Opens at time -10: light from a focus at distance 10 then crosses the lens at time 0. */
    public static final FocusSurfaceShutter DEFAULT = new FocusSurfaceShutter(-10);

    /** Checks the time. */
    public FocusSurfaceShutter {
        Require.coordinate("openingTime", openingTime);
    }

    @Override
    public double transmissionTime(LensRay ray, SpaceTimeTransformation sceneFromCamera) {
        return openingTime + ray.focusDistance();
    }

    @Override
    public boolean needsFocus() {
        return true;
    }
}
