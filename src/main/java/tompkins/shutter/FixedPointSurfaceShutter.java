package tompkins.shutter;

import tompkins.property.Meaning;
import tompkins.spacetime.SpaceTimeTransformation;

/**
 * The shutter for which the surface in focus is the fixed-point surface of the change of frame: the light leaves each
 * of its points I at the time at which the point has the same coordinates in both frames, so that the surface looks
 * undistorted. The time at the lens is later by the signed distance to I.
 */
@Meaning(
        "Light leaves each point in focus when the point has the same place in both frames; the focus looks undistorted")
public record FixedPointSurfaceShutter() implements Shutter {

    /** The only one. */
    public static final FixedPointSurfaceShutter DEFAULT = new FixedPointSurfaceShutter();

    @Override
    public double transmissionTime(LensRay ray, SpaceTimeTransformation sceneFromCamera) {
        return sceneFromCamera.fixedPointTime(ray.focusPoint()) + ray.focusDistance();
    }

    @Override
    public boolean hasOpeningTime() {
        return false;
    }

    @Override
    public double openingTime() {
        return 0;
    }

    @Override
    public boolean needsFocus() {
        return true;
    }
}
