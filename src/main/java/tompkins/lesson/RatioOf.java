package tompkins.lesson;

import tompkins.property.Meaning;
import tompkins.property.Require;

/** The first measurement divided by the second. */
@Meaning("The first measurement divided by the second")
public record RatioOf(
        @Meaning("The first measurement") Measurement first,
        @Meaning("The second measurement") Measurement second) implements Measurement {

    /** Of two readings in the middle of the picture. */
    public static final RatioOf DEFAULT = new RatioOf(RayReading.DEFAULT, RayReading.DEFAULT);

    /** Checks that nothing is missing. */
    public RatioOf {
        Require.present("first", first);
        Require.present("second", second);
    }
}
