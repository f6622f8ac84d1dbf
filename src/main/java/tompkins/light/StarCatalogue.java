package tompkins.light;

import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The bright stars of the sky: 8874 of magnitude 6.5 or less, from the XHIP catalogue (Anderson, Francis 2012), by way
 * of d3-celestial. The files of resources, and the script that makes them, name their sources.
 */
public final class StarCatalogue {

    /** The magnitude of the faintest star; people see about as much. */
    public static final double FAINTEST = 6.5;

    private static final List<Star> STARS = ResourceTable.lines("stars.csv").stream()
            .skip(1)
            .map(StarCatalogue::star)
            .toList();

    private StarCatalogue() {}

    private static Star star(String[] cells) {
        double[] numbers = Arrays.stream(cells).mapToDouble(Double::parseDouble).toArray();
        return new Star(numbers[0], numbers[1], numbers[2], numbers[3]);
    }

    /** The stars whose magnitude is not above a limit, the brightest first. */
    public static List<Star> upTo(double limit) {
        return STARS.stream().takeWhile(star -> star.magnitude() <= limit).toList();
    }

    /** The names of the thirty brightest stars, the brightest first. */
    public static Map<Star, String> names() {
        Map<Star, String> names = new LinkedHashMap<>();
        ResourceTable.lines("star-names.csv").stream()
                .skip(1)
                .forEach(cells -> names.put(at(Double.parseDouble(cells[0]), Double.parseDouble(cells[1])), cells[2]));
        return Collections.unmodifiableMap(names);
    }

    private static Star at(double rightAscension, double declination) {
        return STARS.stream()
                .filter(star ->
                        star.rightAscensionDegrees() == rightAscension && star.declinationDegrees() == declination)
                .findFirst()
                .orElseThrow();
    }
}
