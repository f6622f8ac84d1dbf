package tompkins.spacetime;

import static java.math.BigDecimal.ONE;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Arrays;
import org.joml.Vector3dc;

/**
 * An event with sixty digits, for the few places where a double does not have enough: a camera that has flown a
 * distance of 1e12 may pass the rods of a scene by less than their radius. Slow; meant for a few events per picture.
 */
public final class PreciseEvent {

    private static final MathContext DIGITS = new MathContext(60);

    /** More digits than a power of {@link #PARTS} loses. */
    private static final MathContext MORE_DIGITS = new MathContext(70);

    private static final BigDecimal LEAST_TERM = ONE.movePointLeft(MORE_DIGITS.getPrecision());

    /** The Taylor series of the exponential function is short for this part of a number. */
    private static final int PARTS = 1 << 12;

    // x, y, z, time
    private final BigDecimal[] coordinates;

    private PreciseEvent(BigDecimal... coordinates) {
        this.coordinates = coordinates;
    }

    /** An event that is given exactly, by finite numbers. */
    public static PreciseEvent of(Event event) {
        return new PreciseEvent(exact(event.x()), exact(event.y()), exact(event.z()), exact(event.time()));
    }

    private static BigDecimal exact(double value) {
        return new BigDecimal(value, DIGITS);
    }

    /** The difference to an event that is given exactly, with all digits. */
    public PreciseEvent minus(Event origin) {
        BigDecimal[] from = of(origin).coordinates;
        BigDecimal[] difference = new BigDecimal[4];
        Arrays.setAll(difference, i -> coordinates[i].subtract(from[i], DIGITS));
        return new PreciseEvent(difference);
    }

    /** The event in doubles. */
    public Event rounded() {
        return new Event(
                coordinates[0].doubleValue(),
                coordinates[1].doubleValue(),
                coordinates[2].doubleValue(),
                coordinates[3].doubleValue());
    }

    /** The Galilean change of frame: the place moves with a velocity for the time of the event. */
    PreciseEvent carried(Vector3dc beta) {
        return moved(
                new BigDecimal[] {exact(beta.x()), exact(beta.y()), exact(beta.z())}, coordinates[3], coordinates[3]);
    }

    /** The place moved by a velocity for some time, at another time. */
    private PreciseEvent moved(BigDecimal[] velocity, BigDecimal duration, BigDecimal time) {
        BigDecimal[] moved = {null, null, null, time};
        for (int axis = 0; axis < 3; axis++) {
            moved[axis] = coordinates[axis].add(velocity[axis].multiply(duration), DIGITS);
        }
        return new PreciseEvent(moved);
    }

    /**
     * The Lorentz transformation from the frame that moves with a velocity, or its opposite (sign -1), into the frame
     * in which it moves.
     */
    PreciseEvent boosted(Velocity velocity, double sign) {
        if (velocity.isRest()) {
            return this;
        }
        Vector3dc given = velocity.given();
        BigDecimal squaredLength = BigDecimal.ZERO;
        for (int axis = 0; axis < 3; axis++) {
            squaredLength = squaredLength.add(exact(given.get(axis)).pow(2), DIGITS);
        }
        BigDecimal length = squaredLength.sqrt(DIGITS);
        BigDecimal properSpeed = properSpeed(velocity, length);
        BigDecimal gamma = ONE.add(properSpeed.pow(2)).sqrt(DIGITS);
        BigDecimal[] proper = new BigDecimal[3];
        BigDecimal along = BigDecimal.ZERO;
        for (int axis = 0; axis < 3; axis++) {
            proper[axis] = properSpeed.multiply(exact(sign * given.get(axis))).divide(length, DIGITS);
            along = along.add(proper[axis].multiply(coordinates[axis]), DIGITS);
        }
        BigDecimal time = coordinates[3];
        BigDecimal duration = along.divide(gamma.add(ONE), DIGITS).add(time, DIGITS);
        return moved(proper, duration, gamma.multiply(time).add(along, DIGITS));
    }

    /** gamma beta, from the numbers by which a velocity was given: a speed, or components of a length. */
    private static BigDecimal properSpeed(Velocity velocity, BigDecimal length) {
        if (velocity.scale() == null) {
            return properSpeed(length);
        }
        BigDecimal value = exact(velocity.value());
        return switch (velocity.scale()) {
            case GAMMA -> value.pow(2).subtract(ONE).sqrt(DIGITS);
            case BETA -> properSpeed(value);
            case ONE_MINUS_BETA -> properSpeed(ONE.subtract(value));
            case RAPIDITY -> {
                BigDecimal growth = exponential(value);
                yield growth.subtract(ONE.divide(growth, DIGITS)).divide(BigDecimal.valueOf(2), DIGITS);
            }
        };
    }

    private static BigDecimal properSpeed(BigDecimal beta) {
        return beta.divide(ONE.subtract(beta.pow(2)).sqrt(DIGITS), DIGITS);
    }

    private static BigDecimal exponential(BigDecimal number) {
        BigDecimal part = number.divide(BigDecimal.valueOf(PARTS), MORE_DIGITS);
        BigDecimal sum = ONE;
        BigDecimal term = part;
        for (int i = 2; term.compareTo(LEAST_TERM) > 0; i++) {
            sum = sum.add(term, MORE_DIGITS);
            term = term.multiply(part).divide(BigDecimal.valueOf(i), MORE_DIGITS);
        }
        return sum.pow(PARTS, MORE_DIGITS);
    }
}
