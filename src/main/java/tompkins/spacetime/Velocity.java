package tompkins.spacetime;

import java.util.Objects;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Precise;
import tompkins.math.Vectors;
import tompkins.property.InvalidPropertyException;
import tompkins.property.NumberText;
import tompkins.property.Require;

/**
 * A velocity below that of light. What is stored is the proper velocity u = gamma beta: with it no formula divides by
 * beta^2, nothing is special at rest, and speeds that differ from 1 by less than a double can show keep all digits.
 *
 * <p>A velocity remembers in which form it was given (as three components, or as a speed on one of the
 * {@link SpeedScale}s with a direction), so that a scene file is written back as it was read.
 */
public final class Velocity {

    private static final Vector3dc FORWARDS = new Vector3d(0, 0, 1);

    /** No motion. */
    public static final Velocity REST = Velocity.of(new Vector3d());

    /** Up to this Lorentz factor all results keep the digits that {@code docs/accuracy.md} promises. */
    public static final double GUARANTEED_GAMMA = 1e6;

    /** Beyond this Lorentz factor a picture would consist of rounding errors. */
    public static final double LARGEST_GAMMA = 1e8;

    private final SpeedScale scale;
    private final double value;
    private final Vector3dc given;

    private final double gamma;
    private final double properSpeed;
    private final Vector3dc direction;
    private final Vector3dc proper;

    private Velocity(
            SpeedScale scale, double value, Vector3dc given, double gamma, double properSpeed, Vector3dc proper) {
        this.scale = scale;
        this.value = value;
        this.given = given;
        this.gamma = gamma;
        this.properSpeed = properSpeed;
        this.direction = properSpeed == 0 ? FORWARDS : Vectors.unit(given);
        this.proper = proper;
    }

    /**
     * A velocity from its components in units of c.
     *
     * @throws InvalidPropertyException if a component is not finite, or the exact length is not below 1
     */
    public static Velocity of(Vector3dc beta) {
        Vector3dc components = Require.finite("velocity", beta);
        double x = components.x();
        double y = components.y();
        double z = components.z();
        double oneMinusSquares = Precise.oneMinusSquares(x, y, z);
        if (!(oneMinusSquares > 0)) {
            throw new InvalidPropertyException(
                    "velocity",
                    "shorter than 1 (the speed of light)",
                    Require.text(components) + " with length " + NumberText.of(Vectors.length(components)));
        }
        double gamma = 1 / Math.sqrt(oneMinusSquares);
        return new Velocity(
                null,
                0,
                components,
                gamma,
                gamma * Vectors.length(components),
                new Vector3d(gamma * x, gamma * y, gamma * z));
    }

    /** As {@link #of(Vector3dc)}. */
    public static Velocity of(double x, double y, double z) {
        return of(new Vector3d(x, y, z));
    }

    /**
     * A velocity from a number that gives its speed, and a direction of any length.
     *
     * @throws InvalidPropertyException if the number lies outside the scale's range, or there is no direction
     */
    public static Velocity of(SpeedScale scale, double value, Vector3dc direction) {
        Vector3dc given = Require.direction("direction", direction);
        double gamma = 0;
        double properSpeed = -1;
        switch (scale) {
            case BETA -> {
                gamma = 1 / Math.sqrt((1 - value) * (1 + value));
                properSpeed = gamma * value;
            }
            case GAMMA -> {
                gamma = value;
                properSpeed = Math.sqrt(value - 1) * Math.sqrt(value + 1);
            }
            case RAPIDITY -> {
                gamma = Math.cosh(value);
                properSpeed = Math.sinh(value);
            }
            case ONE_MINUS_BETA -> {
                gamma = 1 / Math.sqrt(value * (2 - value));
                properSpeed = value <= 1 ? gamma * (1 - value) : -1;
            }
        }
        if (!(properSpeed >= 0 && gamma >= 1 && gamma < Double.POSITIVE_INFINITY)) {
            throw new InvalidPropertyException(scale.key(), scale.range(), value);
        }
        Vector3d proper =
                properSpeed == 0 ? new Vector3d() : Vectors.unit(given).mul(properSpeed);
        return new Velocity(scale, value, given, gamma, properSpeed, proper);
    }

    /** A velocity from its proper velocity u = gamma beta, which is kept as a rapidity along a direction. */
    public static Velocity ofProper(Vector3dc proper) {
        double speed = Vectors.length(proper);
        // asinh, with all its digits near rest
        double rapidity = Math.log1p(speed + speed * (speed / (1 + Math.sqrt(1 + speed * speed))));
        return speed == 0 ? REST : of(SpeedScale.RAPIDITY, rapidity, Vectors.unit(proper));
    }

    /**
     * The same speed along another direction of any length, which stays as it is given. Components become a speed on a
     * scale: beta, or gamma where they are so near the speed of light that beta may have no digits left.
     *
     * @throws InvalidPropertyException if there is no direction
     */
    public Velocity along(Vector3dc newDirection, SpeedScale scaleForComponents) {
        SpeedScale newScale = scale != null ? scale : speed() < 1 ? scaleForComponents : SpeedScale.GAMMA;
        return of(newScale, newScale.valueOf(this), newDirection);
    }

    /**
     * The velocity of a description, if it is not so fast that pictures show nothing but rounding errors.
     *
     * @throws InvalidPropertyException if it is beyond {@link #LARGEST_GAMMA}
     */
    public static Velocity required(String property, Velocity velocity) {
        if (velocity.gamma > LARGEST_GAMMA) {
            throw new InvalidPropertyException(
                    property,
                    "at most that of gamma 1e8",
                    "that of gamma " + NumberText.of(NumberText.rounded(velocity.gamma, 10)));
        }
        return velocity;
    }

    /** Whether nothing moves. */
    public boolean isRest() {
        return properSpeed == 0;
    }

    /** The Lorentz factor, from 1 upwards. */
    public double gamma() {
        return gamma;
    }

    /** gamma - 1, also where gamma itself rounds to 1. */
    public double gammaMinusOne() {
        return properSpeed / (gamma + 1) * properSpeed;
    }

    /** gamma beta, the length of the proper velocity. */
    public double properSpeed() {
        return properSpeed;
    }

    /** The proper velocity u = gamma beta. */
    public Vector3dc proper() {
        return proper;
    }

    /** The unit vector along the velocity; the z axis at rest. */
    public Vector3dc direction() {
        return direction;
    }

    /** The speed beta; 1 where it rounds to 1. */
    public double speed() {
        return scale == SpeedScale.BETA ? value : properSpeed / gamma;
    }

    /** 1 - beta, with all its digits. */
    public double oneMinusSpeed() {
        return scale == SpeedScale.ONE_MINUS_BETA ? value : 1 / (gamma * (gamma + properSpeed));
    }

    /** The rapidity eta = artanh(beta). */
    public double rapidity() {
        return scale == SpeedScale.RAPIDITY ? value : Math.log1p(gammaMinusOne() + properSpeed);
    }

    /**
     * exp(-eta) = gamma - gamma beta: the frequency in the scene of light from straight ahead, divided by what the
     * camera sees.
     */
    public double expMinusRapidity() {
        return 1 / (gamma + properSpeed);
    }

    /** The components of beta; as given, where they were given. */
    public Vector3dc components() {
        return scale == null ? given : new Vector3d(proper).div(gamma);
    }

    /** The scale on which the speed was given, or null if the components were given. */
    public SpeedScale scale() {
        return scale;
    }

    /** The number on the scale; 0 if the components were given. */
    public double value() {
        return value;
    }

    /** The direction as it was given, of any length; the components if those were given. */
    public Vector3dc given() {
        return given;
    }

    /** The direction as it was given, of any length, also at rest; the z axis if there never was one. */
    public Vector3dc givenDirection() {
        return scale == null && isRest() ? FORWARDS : given;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Velocity velocity
                && scale == velocity.scale
                && value == velocity.value
                && given.equals(velocity.given);
    }

    @Override
    public int hashCode() {
        // -0.0 equals 0.0
        return Objects.hash(scale, value + 0.0, given);
    }

    @Override
    public String toString() {
        return scale == null
                ? Require.text(given)
                : scale.key() + " " + NumberText.of(value) + " along " + Require.text(given);
    }
}
