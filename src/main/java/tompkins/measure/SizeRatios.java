package tompkins.measure;

import java.util.List;
import java.util.Optional;
import java.util.Set;

/** How many times as large something is in one picture as in another. */
public final class SizeRatios {

    /** What is a size, whose ratio means something; positions, times and deviations are none. */
    private static final Set<String> SIZES = Set.of(
            "cameraAngle",
            "sceneAngle",
            "sceneDistance",
            "cameraDistance",
            "objectDistance",
            "halfAngle",
            "length",
            "semiMajorAxis",
            "semiMinorAxis",
            "semiLatusRectum");

    private SizeRatios() {}

    /** The ratios of the sizes that were measured in both pictures, under the keys of these. */
    public static List<Quantity> of(Measured measured, Measured other) {
        return measured.quantities()
                .filter(size -> SIZES.contains(size.key()))
                .flatMap(size -> same(size, other).map(there -> ratio(size, there)).stream())
                .toList();
    }

    private static Optional<Quantity> same(Quantity size, Measured other) {
        return other.quantities()
                .filter(there -> there.key().equals(size.key()) && there.value() != 0)
                .findFirst();
    }

    private static Quantity ratio(Quantity here, Quantity there) {
        double ratio = here.value() / there.value();
        double uncertainty = Math.hypot(here.uncertainty(), ratio * there.uncertainty()) / Math.abs(there.value());
        return new Quantity(here.key(), here.name(), "", ratio, uncertainty);
    }
}
