package tompkins.measure;

import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;

/** What can be measured between points of a picture. */
public enum MeasureKind {
    /** Angles, lengths, times and the interval between two points. */
    BETWEEN(2, 2),
    /** What the line between two points shows. */
    PROFILE(2, 2),
    /** The circle of directions through three points or more. */
    CIRCLE(3, Integer.MAX_VALUE),
    /** How straight two points or more lie. */
    LINE(2, Integer.MAX_VALUE);

    private final int fewest;
    private final int most;

    MeasureKind(int fewest, int most) {
        this.fewest = fewest;
        this.most = most;
    }

    /** The kind of a name. */
    public static Optional<MeasureKind> named(String name) {
        return Stream.of(values()).filter(kind -> kind.toString().equals(name)).findFirst();
    }

    /** The fewest points that it needs. */
    public int fewest() {
        return fewest;
    }

    /** The most points that it takes. */
    public int most() {
        return most;
    }

    /** Its name in lower case. */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }
}
