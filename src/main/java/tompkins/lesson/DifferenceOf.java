package tompkins.lesson;

import tompkins.property.Meaning;
import tompkins.property.Require;

/** The first measurement minus the second. */
@Meaning("The first measurement minus the second")
public record DifferenceOf(
        @Meaning("The first measurement") Measurement first,
        @Meaning("The second measurement") Measurement second) implements Measurement {

    /** Of two readings in the middle of the picture. */
    public static final DifferenceOf DEFAULT = new DifferenceOf(RayReading.DEFAULT, RayReading.DEFAULT);

    /** Checks that nothing is missing. */
    public DifferenceOf {
        Require.present("first", first);
        Require.present("second", second);
    }
}
