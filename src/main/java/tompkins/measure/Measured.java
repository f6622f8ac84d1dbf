package tompkins.measure;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.joml.Vector2dc;

/**
 * What was measured.
 *
 * @param facts what is told about it; nothing about a profile without an edge
 * @param profile what points of a line show; null unless it is a profile
 * @param lines what was fitted, as lines of the picture from point to point, in pixels
 */
public record Measured(List<Fact> facts, List<Sighting> profile, List<List<Vector2dc>> lines) {

    /** What is a size, whose ratio means something; positions, times and deviations are none. */
    private static final Set<String> SIZES = Set.of(
            "cameraAngle", "sceneAngle", "sceneDistance", "cameraDistance", "objectDistance", "halfAngle", "length");

    /** Its numbers. */
    public Stream<Quantity> quantities() {
        return facts.stream().filter(Quantity.class::isInstance).map(Quantity.class::cast);
    }

    /** How many times as large the sizes are as in another picture, under the keys of those that both have. */
    public Map<String, Quantity> ratiosTo(Measured other) {
        Map<String, Quantity> ratios = new LinkedHashMap<>();
        quantities()
                .filter(size -> SIZES.contains(size.key()))
                .forEach(size -> other.quantities()
                        .filter(there -> there.key().equals(size.key()) && there.value() != 0)
                        .findFirst()
                        .ifPresent(there -> ratios.put(size.key(), ratio(size, there))));
        return ratios;
    }

    private static Quantity ratio(Quantity here, Quantity there) {
        double ratio = here.value() / there.value();
        double uncertainty = Math.hypot(here.uncertainty(), ratio * there.uncertainty()) / Math.abs(there.value());
        return new Quantity(here.key(), here.name(), "", ratio, uncertainty);
    }
}
