package tompkins.spacetime;

import org.hipparchus.dfp.Dfp;
import org.hipparchus.dfp.DfpField;
import org.hipparchus.dfp.DfpMath;
import org.joml.Vector3dc;

/** The Lorentz transformation of events with sixty digits. */
final class PreciseTransformation {

    private final DfpField numbers = PreciseEvent.NUMBERS;
    private final Dfp gamma;
    private final Dfp[] proper = new Dfp[3];

    /**
     * From the frame that moves with the given velocity, or its opposite (sign -1), into the frame in which it moves.
     */
    PreciseTransformation(Velocity velocity, double sign) {
        Vector3dc given = velocity.given();
        Dfp squaredLength = PreciseEvent.exact(given.x())
                .multiply(PreciseEvent.exact(given.x()))
                .add(PreciseEvent.exact(given.y()).multiply(PreciseEvent.exact(given.y())))
                .add(PreciseEvent.exact(given.z()).multiply(PreciseEvent.exact(given.z())));
        Dfp one = numbers.getOne();
        Dfp properSpeed;
        if (velocity.scale() == null) {
            gamma = one.divide(one.subtract(squaredLength).sqrt());
            properSpeed = gamma.multiply(squaredLength.sqrt());
        } else {
            Dfp value = PreciseEvent.exact(velocity.value());
            gamma = gamma(velocity.scale(), value);
            properSpeed = gamma.subtract(one).multiply(gamma.add(one)).sqrt();
        }
        boolean rest = velocity.isRest();
        Dfp scale = rest ? numbers.getZero() : properSpeed.divide(squaredLength.sqrt());
        for (int axis = 0; axis < 3; axis++) {
            proper[axis] = scale.multiply(PreciseEvent.exact(sign * given.get(axis)));
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

    PreciseEvent transform(PreciseEvent event) {
        Dfp along = proper[0]
                .multiply(event.coordinate(0))
                .add(proper[1].multiply(event.coordinate(1)))
                .add(proper[2].multiply(event.coordinate(2)));
        Dfp time = event.coordinate(3);
        Dfp factor = along.divide(gamma.add(numbers.getOne())).add(time);
        Dfp[] moved = new Dfp[4];
        for (int axis = 0; axis < 3; axis++) {
            moved[axis] = event.coordinate(axis).add(proper[axis].multiply(factor));
        }
        moved[3] = gamma.multiply(time).add(along);
        return new PreciseEvent(moved);
    }
}
