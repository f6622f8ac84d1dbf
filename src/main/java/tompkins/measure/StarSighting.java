package tompkins.measure;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.joml.Vector3dc;
import tompkins.light.ColourLaw;
import tompkins.light.Star;
import tompkins.light.StarCatalogue;
import tompkins.measure.Fact.Group;
import tompkins.measure.Fact.Word;
import tompkins.property.NumberText;
import tompkins.studio.StarSky;
import tompkins.studio.Studio;
import tompkins.trace.SampleHistory;
import tompkins.world.FrameAppearance;

/**
 * The star of a sky that is nearest to a direction of the scene.
 *
 * @param star the star
 * @param angle from the direction to the star, in radians
 */
record StarSighting(Star star, double angle) {

    private static final String DEGREES = "degrees";
    private static final String KELVINS = "K";

    private static final Map<Star, String> NAMES = StarCatalogue.names();

    /** The nearest star that a sky shows; none if it shows no star. */
    static Optional<StarSighting> nearest(StarSky sky, Vector3dc direction) {
        return StarCatalogue.upTo(sky.limit()).stream()
                .map(star -> new StarSighting(star, Angles.between(direction, sky.direction(star))))
                .min(Comparator.comparingDouble(StarSighting::angle));
    }

    /** How many stars of a sky the camera sees within an angle, in radians, of the direction in which it moves. */
    static long count(StarSky sky, Studio studio, double angle) {
        FrameAppearance scene = new FrameAppearance(studio, null);
        Vector3dc ahead = studio.velocity().direction();
        return StarCatalogue.upTo(sky.limit()).stream()
                .filter(star -> Angles.between(scene.look(sky.direction(star)), ahead) <= angle)
                .count();
    }

    /** What there is to tell, beside a ray that ends in the sky. */
    Fact fact(Studio studio, StarSky sky, SampleHistory life) {
        List<Fact> facts = new ArrayList<>();
        String name = NAMES.getOrDefault(star, "");
        facts.add(new Word("name", name.isEmpty() ? "" : "name", name));
        add(facts, "separationDegrees", "angle to it (scene)", DEGREES, Math.toDegrees(angle));
        add(facts, "rightAscensionDegrees", "right ascension", DEGREES, star.rightAscensionDegrees());
        add(facts, "declinationDegrees", "declination", DEGREES, star.declinationDegrees());
        add(facts, "magnitude", "magnitude V at rest", "", star.magnitude());
        add(facts, "temperature", "colour temperature at rest", KELVINS, star.temperature());
        if (studio.shiftsColours()) {
            double dopplerFactor = dopplerFactor(studio, sky, life);
            double factor = studio.colours().starFactor(star.temperature(), dopplerFactor);
            add(facts, "magnitudeSeen", "magnitude as seen", "", star.magnitude() - 2.5 * Math.log10(factor));
            if (studio.colours() == ColourLaw.DOPPLER) {
                double seen = dopplerFactor * star.temperature();
                add(facts, "temperatureSeen", "colour temperature as seen", KELVINS, seen);
            }
        }
        return new Group("nearestStar", "Nearest star in that direction", facts);
    }

    /** That of the star, if its light comes straight through vacuum; else that of the ray. */
    private double dopplerFactor(Studio studio, StarSky sky, SampleHistory life) {
        boolean isStraight = life.hits().isEmpty() && life.lastSlowness() == 1;
        return isStraight
                ? new FrameAppearance(studio, null).dopplerFactorAlong(sky.direction(star))
                : life.lastDopplerFactor();
    }

    /** Adds a number: with all digits for programs, and with those that mean something for people. */
    private static void add(List<Fact> facts, String key, String name, String unit, double value) {
        facts.add(Quantity.exact(key, "", unit, value));
        facts.add(Quantity.exact("", name, unit, NumberText.rounded(value, 6)));
    }
}
