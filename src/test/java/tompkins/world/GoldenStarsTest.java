package tompkins.world;

import static org.assertj.core.api.Assertions.assertThat;
import static tompkins.golden.GoldenTable.U;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.ToDoubleBiFunction;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import tompkins.golden.GoldenRow;
import tompkins.golden.GoldenTable;
import tompkins.golden.Worst;
import tompkins.light.ColourLaw;
import tompkins.light.Star;
import tompkins.light.StarCatalogue;
import tompkins.measure.Angles;
import tompkins.ray.Colour;
import tompkins.spacetime.Velocity;
import tompkins.studio.StarSky;
import tompkins.studio.Studio;

/** Where stars are seen, how bright, and in which colour, against the reference data, row by row. */
class GoldenStarsTest {

    private static final List<GoldenRow> ROWS = GoldenTable.rows("m12_stars");

    private static final Map<String, Star> NAMED =
            StarCatalogue.names().entrySet().stream().collect(Collectors.toMap(Map.Entry::getValue, Map.Entry::getKey));

    /** What the reference data tell of a star. */
    enum StarQuantity {
        DIRECTION((row, seen) -> Worst.share(row.distance(seen.scene(), "n_"), 4 * U * row.number("acond_n"))),
        CAMERA_DIRECTION(
                (row, seen) -> Worst.share(row.distance(seen.look(), "dir_"), 4 * U * row.number("acond_dir"))),
        DOPPLER_FACTOR(
                (row, seen) -> Worst.share(row.difference(seen.dopplerFactor(), "D"), 4 * U * row.number("acond_D"))),
        /** Between vectors of doubles, whose rounding alone turns each of them by up to u. */
        ANGLE((row, seen) -> row.isNumber("angle")
                ? Worst.share(
                        row.difference(Angles.between(seen.look(), row.vector("beta_")), "angle"),
                        4 * U * row.number("acond_angle") + 2 * U)
                : 0),
        FLUX_AT_REST(
                (row, seen) -> Worst.share(row.relativeDifference(seen.star().light(), "flux_rest"), 8 * U)),
        FLUX_OF_SEARCHLIGHT((row, seen) -> {
            double flux = seen.star().light() * seen.factor(ColourLaw.SEARCHLIGHT);
            return Worst.share(row.relativeDifference(flux, "flux_searchlight"), relative(row));
        }),
        FACTOR_OF_DOPPLER((row, seen) -> {
            double error = row.relativeDifference(seen.factor(ColourLaw.DOPPLER), "factor_doppler");
            return Worst.share(error, row.number("temperature_seen") > 1500 ? 1e-4 : 1e-3);
        }),
        TEMPERATURE(
                (row, seen) -> Worst.share(row.relativeDifference(seen.star().temperature(), "temperature"), 8 * U)),
        TEMPERATURE_SEEN((row, seen) -> {
            double temperature = seen.dopplerFactor() * seen.star().temperature();
            return Worst.share(row.relativeDifference(temperature, "temperature_seen"), relative(row));
        }),
        COLOUR_AT_REST((row, seen) -> {
            Colour colour = ColourLaw.UNCHANGED.ofBlackBody(seen.star().temperature(), 1);
            return colours(row, "rest_", colour.times(seen.star().light()), row.number("temperature"));
        }),
        COLOUR_SEEN((row, seen) -> {
            double square = seen.dopplerFactor() * seen.dopplerFactor();
            Colour colour = ColourLaw.DOPPLER.ofBlackBody(seen.star().temperature(), seen.dopplerFactor());
            return colours(row, "seen_", colour.times(seen.star().light() / square), row.number("temperature_seen"));
        });

        private final ToDoubleBiFunction<GoldenRow, Seen> excess;

        StarQuantity(ToDoubleBiFunction<GoldenRow, Seen> excess) {
            this.excess = excess;
        }

        private static double relative(GoldenRow row) {
            return 8 * U * Math.max(1, row.number("acond_D") / row.number("D"));
        }

        /** A screen cannot show channels below 0. The table of the program is meant to be right to 1e-4. */
        private static double colours(GoldenRow row, String prefix, Colour found, double temperature) {
            double[] expected = DoubleStream.of(
                            row.number(prefix + "r"), row.number(prefix + "g"), row.number(prefix + "b"))
                    .map(channel -> Math.max(0, channel))
                    .toArray();
            double error = Math.max(
                    Math.abs(found.red() - expected[0]),
                    Math.max(Math.abs(found.green() - expected[1]), Math.abs(found.blue() - expected[2])));
            double brightest = DoubleStream.of(expected).max().orElseThrow();
            return Worst.share(error / brightest, temperature > 1500 ? 1e-4 : 1e-3);
        }
    }

    /** A star of a row, as the program sees it. */
    record Seen(Star star, Vector3d scene, Vector3d look, double dopplerFactor) {

        double factor(ColourLaw law) {
            return law.starFactor(star.temperature(), dopplerFactor);
        }

        static Seen of(GoldenRow row) {
            Star star = new Star(row.number("ra"), row.number("dec"), row.number("v"), row.number("bv"));
            FrameAppearance frame =
                    new FrameAppearance(Studio.DEFAULT.withVelocity(Velocity.of(row.vector("beta_"))), null);
            Vector3d scene = StarSky.DEFAULT.direction(star);
            Vector3d look = frame.look(scene);
            return new Seen(star, scene, look, frame.dopplerFactorAlong(scene));
        }
    }

    @ParameterizedTest
    @EnumSource
    void starsPassEveryRow(StarQuantity quantity) {
        Worst worst = Worst.of(ROWS, row -> quantity.excess.applyAsDouble(row, Seen.of(row)));
        assertThat(worst).matches(Worst::passes);
    }

    @Test
    void starsOfTheRowsAreInTheCatalogue() {
        List<Star> stars = StarCatalogue.upTo(StarCatalogue.FAINTEST);
        assertThat(ROWS)
                .allSatisfy(row -> assertThat(stars).contains(Seen.of(row).star()));
    }

    /** The reference names forty stars by their numbers in the Hipparcos catalogue; thirty of the program are less. */
    @Test
    void namedStarsHaveTheNamesOfTheReference() {
        assertThat(NAMED).hasSize(30);
        assertThat(ROWS.stream().filter(row -> NAMED.containsKey(row.text("name"))))
                .hasSizeGreaterThan(60)
                .allSatisfy(row -> assertThat(NAMED.get(row.text("name")))
                        .isEqualTo(Seen.of(row).star()));
    }

    @ParameterizedTest
    @EnumSource(
            value = ColourLaw.class,
            names = {"UNCHANGED", "SEARCHLIGHT"})
    void asManyStarsAreSeenAsTheReferenceCounts(ColourLaw law) {
        List<Star> stars = StarCatalogue.upTo(StarCatalogue.FAINTEST);
        String name = law.name().toLowerCase(Locale.ROOT);
        for (GoldenRow row : GoldenTable.rows("m12_counts")) {
            Vector3d motion = row.vector("dir_");
            FrameAppearance frame = new FrameAppearance(
                    Studio.DEFAULT.withVelocity(Velocity.of(motion.mul(row.number("beta"), new Vector3d()))), null);
            int all = 0;
            int ahead = 0;
            for (Star star : stars) {
                Vector3d direction = StarSky.DEFAULT.direction(star);
                Vector3d look = frame.look(direction);
                double dopplerFactor = frame.dopplerFactorAlong(direction);
                double seen = star.light() * law.starFactor(star.temperature(), dopplerFactor);
                if (-2.5 * Math.log10(seen) <= row.number("limit") + 1e-9) {
                    all++;
                    ahead += look.dot(motion) > 0 ? 1 : 0;
                }
            }
            assertThat(all).as("%s all", row.id()).isEqualTo((int) row.number("all_" + name));
            assertThat(ahead).as("%s front", row.id()).isEqualTo((int) row.number("front_" + name));
        }
    }
}
