package tompkins.shutter;

import tompkins.math.RigidMotion;
import tompkins.property.Descriptions;
import tompkins.spacetime.SpaceTimeTransformation;

/**
 * A model of the shutter: it decides at what time each ray crosses the lens, and with it from which event the ray is
 * traced. Descriptions, immutable; all times in the camera frame, c = 1 (Courtial et al. 2016, section 3).
 */
public sealed interface Shutter
        permits AperturePlaneShutter,
                DetectorPlaneShutter,
                LensHologramShutter,
                FocusSurfaceShutter,
                ArbitraryPlaneShutter,
                FixedPointSurfaceShutter,
                AddedShutter {

    /**
     * The time at which a ray crosses the lens. Not finite if the ray never meets the shutter, or meets it at infinity:
     * such a ray brings no light.
     *
     * @param ray the ray, in the camera frame
     * @param sceneFromCamera the change of frame, which only {@link FixedPointSurfaceShutter} needs
     */
    double transmissionTime(LensRay ray, SpaceTimeTransformation sceneFromCamera);

    /** Whether it opens at a time that can be chosen. */
    default boolean hasOpeningTime() {
        return true;
    }

    /** The same shutter with another opening time; itself if it has none. */
    default Shutter openedAt(double openingTime) {
        return hasOpeningTime() ? Descriptions.with(this, "openingTime", openingTime) : this;
    }

    /**
     * The same shutter after a motion of the camera in its rest frame; what stands at a place of that frame goes along.
     */
    default Shutter moved(RigidMotion motion) {
        return this;
    }

    /** The opening time, or 0 if the model has none. */
    double openingTime();

    /** Whether the time depends on where the camera is focused, so that a pinhole needs a focus, too. */
    default boolean needsFocus() {
        return false;
    }
}
