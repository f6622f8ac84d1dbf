package tompkins.spacetime;

import java.util.Arrays;
import org.hipparchus.dfp.Dfp;
import org.hipparchus.dfp.DfpField;
import org.hipparchus.dfp.DfpMath;
import org.joml.Vector3dc;

/**
 * An event with sixty digits, for the few places where a double does not have enough: a camera that has flown a
 * distance of 1e12 may pass the rods of a scene by less than their radius. Slow; meant for a few events per picture.
 */
public final class PreciseEvent {

    private static final DfpField NUMBERS = new DfpField(60);
    private static final Dfp ONE = NUMBERS.getOne();

    // x, y, z, time
    private final Dfp[] coordinates;

    private PreciseEvent(Dfp... coordinates) {
        this.coordinates = coordinates;
    }

    /** An event that is given exactly. */
    public static PreciseEvent of(Event event) {
        return new PreciseEvent(exact(event.x()), exact(event.y()), exact(event.z()), exact(event.time()));
    }

    private static Dfp exact(double value) {
        return NUMBERS.newDfp(value);
    }

    /** The difference to an event that is given exactly, with all digits. */
    public PreciseEvent minus(Event origin) {
        Dfp[] from = of(origin).coordinates;
        Dfp[] difference = new Dfp[4];
        Arrays.setAll(difference, i -> coordinates[i].subtract(from[i]));
        return new PreciseEvent(difference);
    }

    /** The event in doubles. */
    public Event rounded() {
        return new Event(
                coordinates[0].toDouble(),
                coordinates[1].toDouble(),
                coordinates[2].toDouble(),
                coordinates[3].toDouble());
    }

    /** The Galilean change of frame: the place moves with a velocity for the time of the event. */
    PreciseEvent carried(Vector3dc beta) {
        Dfp[] carried = coordinates.clone();
        for (int axis = 0; axis < 3; axis++) {
            carried[axis] = carried[axis].add(coordinates[3].multiply(exact(beta.get(axis))));
        }
        return new PreciseEvent(carried);
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
        Dfp length = NUMBERS.getZero();
        for (int axis = 0; axis < 3; axis++) {
            length = length.add(exact(given.get(axis)).multiply(exact(given.get(axis))));
        }
        length = length.sqrt();
        Dfp properSpeed = properSpeed(velocity, length);
        Dfp gamma = ONE.add(properSpeed.multiply(properSpeed)).sqrt();
        Dfp[] proper = new Dfp[3];
        Dfp along = NUMBERS.getZero();
        for (int axis = 0; axis < 3; axis++) {
            proper[axis] = properSpeed.multiply(exact(sign * given.get(axis))).divide(length);
            along = along.add(proper[axis].multiply(coordinates[axis]));
        }
        Dfp time = coordinates[3];
        Dfp factor = along.divide(gamma.add(ONE)).add(time);
        return new PreciseEvent(
                coordinates[0].add(proper[0].multiply(factor)),
                coordinates[1].add(proper[1].multiply(factor)),
                coordinates[2].add(proper[2].multiply(factor)),
                gamma.multiply(time).add(along));
    }

    /** gamma beta, from the numbers by which a velocity was given: a speed, or components of a length. */
    private static Dfp properSpeed(Velocity velocity, Dfp length) {
        if (velocity.scale() == null) {
            return properSpeed(length);
        }
        Dfp value = exact(velocity.value());
        return switch (velocity.scale()) {
            case GAMMA -> value.subtract(ONE).multiply(value.add(ONE)).sqrt();
            case BETA -> properSpeed(value);
            case ONE_MINUS_BETA -> properSpeed(ONE.subtract(value));
            case RAPIDITY -> {
                Dfp growth = DfpMath.exp(value);
                yield growth.subtract(ONE.divide(growth)).divide(2);
            }
        };
    }

    private static Dfp properSpeed(Dfp beta) {
        return beta.divide(ONE.subtract(beta).multiply(ONE.add(beta)).sqrt());
    }
}
