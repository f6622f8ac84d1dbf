package tompkins.spacetime;

import org.hipparchus.dfp.Dfp;
import org.hipparchus.dfp.DfpField;

/**
 * An event with sixty digits, for the few places where a double does not have enough: a camera that has flown a
 * distance of 1e12 may pass the rods of a scene by less than their radius. Slow; meant for a few events per picture.
 */
public final class PreciseEvent {

    private static final int DIGITS = 60;

    /** The numbers that events and changes of frame are made of. */
    static final DfpField NUMBERS = new DfpField(DIGITS);

    // x, y, z, time
    private final Dfp[] coordinates;

    PreciseEvent(Dfp... coordinates) {
        this.coordinates = coordinates;
    }

    /** An event that is given exactly. */
    public static PreciseEvent of(Event event) {
        return new PreciseEvent(exact(event.x()), exact(event.y()), exact(event.z()), exact(event.time()));
    }

    static Dfp exact(double value) {
        return NUMBERS.newDfp(value);
    }

    /** Place (0, 1, 2) or time (3). */
    Dfp coordinate(int index) {
        return coordinates[index];
    }

    /** The event as seen from another, rounded only at the end. */
    public Event minus(Event origin) {
        return new Event(
                coordinates[0].subtract(exact(origin.x())).toDouble(),
                coordinates[1].subtract(exact(origin.y())).toDouble(),
                coordinates[2].subtract(exact(origin.z())).toDouble(),
                coordinates[3].subtract(exact(origin.time())).toDouble());
    }

    /** The difference to an event that is given exactly, with all digits. */
    public PreciseEvent from(Event origin) {
        return new PreciseEvent(
                coordinates[0].subtract(exact(origin.x())),
                coordinates[1].subtract(exact(origin.y())),
                coordinates[2].subtract(exact(origin.z())),
                coordinates[3].subtract(exact(origin.time())));
    }

    /** The event in doubles. */
    public Event rounded() {
        return minus(Event.ORIGIN);
    }
}
