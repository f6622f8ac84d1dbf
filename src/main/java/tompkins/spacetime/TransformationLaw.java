package tompkins.spacetime;

/** The law by which the camera's motion changes what it sees. */
public enum TransformationLaw {
    /** Special relativity. */
    LORENTZ,
    /** Newton's mechanics with a finite speed of light. */
    GALILEAN,
    /** The velocity is ignored. */
    NONE;

    /** The number by which speeds are told: with Newton gamma means nothing. */
    public SpeedScale speedScale() {
        return this == GALILEAN ? SpeedScale.BETA : SpeedScale.GAMMA;
    }

    /** The change from the frame of a camera with the given velocity to the scene frame. */
    public SpaceTimeTransformation sceneFromCamera(Velocity velocity) {
        if (velocity.isRest()) {
            return new IdentityTransformation();
        }
        return switch (this) {
            case LORENTZ -> new LorentzTransformation(velocity);
            case GALILEAN -> new GalileanTransformation(velocity);
            case NONE -> new IdentityTransformation();
        };
    }
}
