package tompkins.world;

import static tompkins.golden.GoldenTable.U;

import java.util.List;
import org.joml.Vector3d;
import tompkins.golden.GoldenRow;
import tompkins.golden.Worst;
import tompkins.spacetime.Event;

/** What the reference data tell of a hit on something that moves, each within 4 u of its condition. */
enum MovingQuantity {
    LAMBDA((row, hit, measures) -> share(row, row.difference(hit.lambda(), "lambda"), "lambda")),
    SCENE_PLACE((row, hit, measures) -> share(row, row.distance(hit.inScene().position(), "s"), "s")),
    SCENE_TIME((row, hit, measures) -> share(row, row.difference(hit.inScene().time(), "st"), "st")),
    OWN_PLACE((row, hit, measures) -> share(row, row.distance(hit.own().position(), "k"), "k")),
    OWN_TIME((row, hit, measures) -> share(row, row.difference(hit.own().time(), "ktau"), "ktau")),
    READING((row, hit, measures) -> {
        double condition = row.number("acond_ktau") + Math.abs(row.number("tau0"));
        return Worst.share(row.difference(hit.hit.clockReading(), "reading"), 4 * U * condition);
    }),
    NORMAL((row, hit, measures) -> share(row, row.distance(hit.normal(), "n"), "n")),
    OWN_DIRECTION((row, hit, measures) -> {
        // what measures has a tangent, not a direction
        Vector3d direction = hit.ownDirection().mul(measures ? hit.ray.directionLength : 1);
        return share(row, row.distance(direction, "kd"), "kd");
    }),
    TANGENT_TIME((row, hit, measures) -> {
        double time = -hit.ray.slowness * hit.ray.directionLength;
        return measures ? share(row, row.difference(time, "kdt"), "kd") : 0;
    }),
    DOPPLER_FACTOR((row, hit, measures) ->
            measures || !row.isNumber("D") ? 0 : share(row, row.difference(hit.dopplerFactor(), "D"), "D"));

    private interface Excess {
        double of(GoldenRow row, FoundHit hit, boolean measures);
    }

    private final Excess excess;

    MovingQuantity(Excess excess) {
        this.excess = excess;
    }

    /** What the ray of a row hits; null if nothing. */
    static FoundHit find(GoldenRow row, boolean measures) {
        Event camera = new Event(row.number("ox"), row.number("oy"), row.number("oz"), row.number("ot"));
        MovingRow scene = MovingRow.of(
                List.of(MovingRow.moving(
                        row.vector("v"), row.vector("p"), row.number("tau0"), MovingRow.shape(row, ""))),
                row.vector("beta_"),
                camera,
                row.has("law", "galilean"));
        return scene.find(scene.inScene(camera, row.vector("d"), measures));
    }

    /** The excess of the quantity over a row: infinite if something is hit that should not be, or not. */
    double excess(GoldenRow row, FoundHit hit, boolean measures) {
        boolean decidable = row.number("decidable_eps") >= 16 * U;
        if (hit == null || row.has("hit", "0")) {
            return (hit == null) == row.has("hit", "0") || !decidable ? 0 : Double.POSITIVE_INFINITY;
        }
        return excess.of(row, hit, measures);
    }

    static double share(GoldenRow row, double error, String column) {
        return Worst.share(error, 4 * U * row.number("acond_" + column));
    }
}
