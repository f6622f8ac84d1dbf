package tompkins.spacetime;

import org.hipparchus.dfp.Dfp;
import org.hipparchus.dfp.DfpField;
import org.hipparchus.dfp.DfpMath;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The Lorentz transformation of events with sixty digits, for the few places where a double has not enough of them: a
 * camera that has flown a distance of 1e12 has passed the rods of a scene by less than their radius. Slow; for one
 * event a picture.
 */
final class PreciseTransformation {

    private static final int DIGITS = 60;

    private final DfpField numbers = new DfpField(DIGITS);
    private final Dfp gamma;
    private final Dfp[] proper = new Dfp[3];

    /**
     * From the frame that moves with the given velocity, or its opposite (sign -1), into the frame in which it moves.
     */
    PreciseTransformation(Velocity velocity, double sign) {
        Vector3dc given = velocity.given();
        Dfp squaredLength = exact(given.x())
                .multiply(exact(given.x()))
                .add(exact(given.y()).multiply(exact(given.y())))
                .add(exact(given.z()).multiply(exact(given.z())));
        Dfp one = numbers.getOne();
        Dfp properSpeed;
        if (velocity.scale() == null) {
            gamma = one.divide(one.subtract(squaredLength).sqrt());
            properSpeed = gamma.multiply(squaredLength.sqrt());
        } else {
            Dfp value = exact(velocity.value());
            gamma = gamma(velocity.scale(), value);
            properSpeed = gamma.subtract(one).multiply(gamma.add(one)).sqrt();
        }
        boolean rest = velocity.isRest();
        Dfp scale = rest ? numbers.getZero() : properSpeed.divide(squaredLength.sqrt());
        for (int axis = 0; axis < 3; axis++) {
            proper[axis] = scale.multiply(exact(sign * given.get(axis)));
        }
    }

    private Dfp gamma(SpeedScale scale, Dfp value) {
        Dfp one = numbers.getOne();
        return switch (scale) {
            case GAMMA -> value;
            case BETA -> one.divide(one.subtract(value).multiply(one.add(value)).sqrt());
            case ONE_MINUS_BETA ->
                one.divide(value.multiply(one.add(one).subtract(value)).sqrt());
            case RAPIDITY -> {
                Dfp growth = DfpMath.exp(value);
                yield growth.add(one.divide(growth)).divide(2);
            }
        };
    }

    private Dfp exact(double value) {
        return numbers.newDfp(value);
    }

    /** The transformed place of an event minus a place that is near it. */
    Vector3d placeFrom(Vector3dc near, Event event) {
        Dfp along = proper[0]
                .multiply(exact(event.x()))
                .add(proper[1].multiply(exact(event.y())))
                .add(proper[2].multiply(exact(event.z())));
        Dfp factor = along.divide(gamma.add(numbers.getOne())).add(exact(event.time()));
        Vector3d place = event.position();
        Vector3d difference = new Vector3d();
        for (int axis = 0; axis < 3; axis++) {
            Dfp moved = exact(place.get(axis)).add(proper[axis].multiply(factor));
            difference.setComponent(axis, moved.subtract(exact(near.get(axis))).toDouble());
        }
        return difference;
    }
}
