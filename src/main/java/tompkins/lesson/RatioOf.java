package tompkins.lesson;

import tompkins.property.Meaning;

/** The first measurement divided by the second. */
@Meaning("The first measurement divided by the second")
public record RatioOf(
        @Meaning("The first measurement") Measurement first,
        @Meaning("The second measurement") Measurement second) implements Measurement {

    /** Of two readings in the middle of the picture. */
    public static final RatioOf DEFAULT = new RatioOf(RayReading.DEFAULT, RayReading.DEFAULT);
}
