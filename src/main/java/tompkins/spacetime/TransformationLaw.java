package tompkins.spacetime;

import java.util.Optional;
import tompkins.property.NumberText;

/** The law by which the camera's motion changes what it sees. */
public enum TransformationLaw {
    /** Special relativity. */
    LORENTZ,
    /** The Galilean change of frame; light has speed 1 relative to the camera. */
    GALILEAN,
    /** The velocity is ignored. */
    NONE;

    /** The number in which speeds are given: gamma means something under Lorentz only. */
    public SpeedScale speedScale() {
        return this == LORENTZ ? SpeedScale.GAMMA : SpeedScale.BETA;
    }

    /**
     * What to say about pictures at a velocity if they may have lost digits: under Lorentz, a warning above
     * {@link Velocity#GUARANTEED_GAMMA}.
     */
    public Optional<String> warning(Velocity velocity) {
        return warning("", velocity.gamma());
    }

    /** As {@link #warning(Velocity)}, for what moves in the scene. */
    public Optional<String> warning(FrameMotion motion) {
        return warning("what moves in the scene is too fast for full accuracy: ", motion.gamma());
    }

    private Optional<String> warning(String beginning, double gamma) {
        return this != LORENTZ || gamma <= Velocity.GUARANTEED_GAMMA
                ? Optional.empty()
                : Optional.of(beginning + "gamma " + NumberText.of(NumberText.rounded(gamma, 3)) + " is above "
                        + NumberText.of(Velocity.GUARANTEED_GAMMA) + "; directions may be wrong by more than "
                        + NumberText.of(NumberText.rounded(8 * gamma * 0x1p-53, 1)) + " radians");
    }

    /** The change from the frame of a camera with the given velocity to the scene frame. */
    public SpaceTimeTransformation sceneFromCamera(Velocity velocity) {
        if (this == NONE || velocity.isRest()) {
            return new IdentityTransformation();
        }
        return this == LORENTZ ? new LorentzTransformation(velocity) : new GalileanTransformation(velocity);
    }
}
