package tompkins.world;

import static tompkins.golden.GoldenTable.U;

import java.util.function.ToDoubleBiFunction;
import org.joml.Vector3d;
import tompkins.golden.GoldenRow;
import tompkins.golden.Worst;
import tompkins.ray.Ray;

/** What the reference data tell of light in a medium that moves, each within 4 u of its condition. */
enum MediumQuantity {
    DIRECTION((row, medium) -> MovingQuantity.share(row, row.distance(medium.met.direction(), "kd_"), "kd")),
    LENGTH((row, medium) -> number(row, medium.met.length(), "len")),
    FREQUENCY((row, medium) -> number(row, medium.met.frequency() * medium.met.length(), "W")),
    SLOWNESS((row, medium) -> number(row, medium.light.slowness(medium.met.length()), "s")),
    SLOWNESS_ABOVE_VACUUM((row, medium) -> {
        double value = medium.slownessAboveVacuum(medium.met);
        boolean isExact = row.number("acond_sm1") == 0;
        return isExact ? Worst.share(row.difference(value, "sm1"), U * Math.abs(value)) : number(row, value, "sm1");
    }),
    DOPPLER_FACTOR((row, medium) -> number(row, medium.met.frequency(), "D")),
    OVERTAKEN_DIRECTION((row, medium) -> row.has("images", "2")
            ? MovingQuantity.share(row, row.distance(medium.overtaken.direction(), "kd2_"), "kd2")
            : 0),
    OVERTAKEN_SLOWNESS((row, medium) ->
            row.has("images", "2") ? number(row, medium.slownessAboveVacuum(medium.overtaken), "sm12") : 0),
    OVERTAKEN_DOPPLER_FACTOR(
            (row, medium) -> row.has("images", "2") ? number(row, medium.overtaken.frequency(), "D2") : 0),
    DISTANCE((row, medium) -> number(row, medium.hit().hit.distance, "dist")),
    LAMBDA((row, medium) -> number(row, medium.hit().lambda(), "lambda")),
    OWN_PLACE((row, medium) ->
            MovingQuantity.share(row, row.distance(medium.hit().own().position(), "k_"), "k")),
    OWN_TIME((row, medium) -> number(row, medium.hit().own().time(), "ktau")),
    SCENE_PLACE((row, medium) ->
            MovingQuantity.share(row, row.distance(medium.hit().inScene().position(), "s_"), "s_")),
    SCENE_TIME((row, medium) -> number(row, medium.hit().inScene().time(), "st")),
    DOPPLER_FACTOR_OF_OBJECT((row, medium) -> number(row, 1 / medium.forObject().frequency, "DJ")),
    LENGTH_FOR_OBJECT((row, medium) -> number(row, medium.forObject().directionLength, "lJ")),
    DIRECTION_BEHIND((row, medium) -> behind(row, medium.behindBoundary(), "ko")),
    SCENE_DIRECTION((row, medium) -> row.has("tir", "1") ? 0 : behind(row, medium.inScene(), "sdir")),
    DOPPLER_FACTOR_OF_SCENE(
            (row, medium) -> row.has("tir", "1") ? 0 : number(row, 1 / medium.inScene().frequency, "DS"));

    private final ToDoubleBiFunction<GoldenRow, MediumRow> excess;

    MediumQuantity(ToDoubleBiFunction<GoldenRow, MediumRow> excess) {
        this.excess = excess;
    }

    /** The error of a row, divided by its limit: at most 1 if it passes. */
    double excess(GoldenRow row, MediumRow medium) {
        return excess.applyAsDouble(row, medium);
    }

    /** What is exact is printed with 34 digits. */
    private static double number(GoldenRow row, double value, String column) {
        double limit = Math.max(4 * U * row.number("acond_" + column), 1e-33 * Math.abs(value));
        return Worst.share(row.difference(value, column), limit);
    }

    private static double behind(GoldenRow row, Ray ray, String column) {
        if (ray == null || row.has("tir", "1")) {
            return (ray == null) == row.has("tir", "1") ? 0 : Double.POSITIVE_INFINITY;
        }
        return MovingQuantity.share(row, row.distance(new Vector3d(ray.dx, ray.dy, ray.dz), column + "_"), column);
    }
}
