package tompkins.bench;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;

/** A part of the report, which can be measured alone. */
enum Part {
    /** The paper's two figures. */
    FIGURES,
    /** Whole commands to the same error, beside POV-Ray. */
    ERROR,
    /** The speed is dragged, without a window. */
    DRAG,
    /** Samples that a wide aperture needs. */
    LENS,
    /** Samples for an error, beside the fewest that any choice of samples takes. */
    SAMPLES,
    /** Time with more and more objects. */
    GROWTH,
    /** What it costs that objects move. */
    MOTION,
    /** From the start of Java to a file, or to a picture on the screen. */
    START,
    /** Another jar, such as that of an earlier commit, in turns with this one; nothing if none is named. */
    BEFORE,
    /** Fig. 1(b) in the window. */
    WINDOW,
    /** Rides in the window. */
    RIDE,
    /** A large picture in little memory. */
    LARGE;

    private static final String ALL = "all";

    /**
     * The parts that are named, with commas between them; {@code all} names each.
     *
     * @throws IllegalArgumentException if there is no such part
     */
    static Set<Part> named(String names) {
        if (names.equals(ALL)) {
            return EnumSet.allOf(Part.class);
        }
        return Arrays.stream(names.split(",", -1))
                .map(Part::ofName)
                .collect(Collectors.toCollection(() -> EnumSet.noneOf(Part.class)));
    }

    private static Part ofName(String name) {
        return Arrays.stream(values())
                .filter(part -> part.label().equals(name))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("tompkins.bench: there is no part \"" + name
                        + "\"; it can be all, or some of these with commas between them: "
                        + Arrays.stream(values()).map(Part::label).collect(Collectors.joining(", "))));
    }

    private String label() {
        return name().toLowerCase(Locale.ROOT);
    }
}
