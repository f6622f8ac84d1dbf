package tompkins.lesson;

import tompkins.property.Meaning;

/** The first measurement minus the second. */
@Meaning("The first measurement minus the second")
public record DifferenceOf(
        @Meaning("The first measurement") Measurement first,
        @Meaning("The second measurement") Measurement second) implements Measurement {

    /** Of two readings in the middle of the picture. */
    public static final DifferenceOf DEFAULT = new DifferenceOf(RayReading.DEFAULT, RayReading.DEFAULT);
}
