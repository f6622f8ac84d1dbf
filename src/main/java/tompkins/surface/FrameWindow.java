package tompkins.surface;

import tompkins.property.Descriptions;
import tompkins.spacetime.Velocity;

/** A sheet that changes the direction of light as a change of frame does, by one law or the other. */
public sealed interface FrameWindow extends Surface permits LorentzWindow, GalileoWindow {

    /** The velocity of the change of frame. */
    Velocity velocity();

    /** The axes in which the velocity is given. */
    WindowAxes axes();

    /** The same window with another velocity. */
    default FrameWindow withVelocity(Velocity other) {
        return Descriptions.with(this, "velocity", other);
    }

    @Override
    default boolean usesCoordinates() {
        return axes() == WindowAxes.SURFACE;
    }

    @Override
    default boolean canTurn() {
        return false;
    }

    @Override
    default Continuation continuation() {
        return Continuation.TURNED;
    }
}
