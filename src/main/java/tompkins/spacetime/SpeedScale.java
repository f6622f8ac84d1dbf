package tompkins.spacetime;

import tompkins.property.Meaning;

/** The numbers by which a speed can be given. */
public enum SpeedScale {
    /** The speed itself, below 1. */
    @Meaning("The speed in units of c")
    BETA("beta", "from 0 to below 1"),
    /** The Lorentz factor 1/sqrt(1 - beta^2), from 1. */
    @Meaning("The Lorentz factor 1/sqrt(1 - beta^2)")
    GAMMA("gamma", "1 or above"),
    /** The rapidity artanh(beta), which adds up when velocities along one line are composed. Beyond 710 the Lorentz factor is no double. */
    @Meaning("The rapidity artanh(beta), which adds up when velocities along one line are composed")
    RAPIDITY("rapidity", "from 0 to 710"),
    /** What the speed lacks to that of light, 1 - beta, for speeds that a decimal fraction cannot hold. */
    @Meaning("What the speed lacks to that of light, 1 - beta")
    ONE_MINUS_BETA("oneMinusBeta", "above 0 and at most 1");

    private final String key;
    private final String range;

    SpeedScale(String key, String range) {
        this.key = key;
        this.range = range;
    }

    /** The name in scene files. */
    public String key() {
        return key;
    }

    /** The allowed values, in words. */
    public String range() {
        return range;
    }

    /** The value of a velocity's speed on this scale. */
    public double valueOf(Velocity velocity) {
        return switch (this) {
            case BETA -> velocity.speed();
            case GAMMA -> velocity.gamma();
            case RAPIDITY -> velocity.rapidity();
            case ONE_MINUS_BETA -> velocity.oneMinusSpeed();
        };
    }
}
