package tompkins.world;

import static org.assertj.core.api.Assertions.assertThat;
import static tompkins.golden.GoldenTable.U;

import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import tompkins.golden.GoldenRow;
import tompkins.golden.GoldenTable;
import tompkins.golden.Worst;
import tompkins.light.Lighting;
import tompkins.light.Sightline;
import tompkins.math.Vectors;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.spacetime.Event;

/** Light of lamps that move, and the shadows of what moves, against the reference data, row by row. */
class GoldenLampsTest {

    private static final List<GoldenRow> LAMPS = GoldenTable.rows("m2_lamps");
    private static final List<GoldenRow> SHADOWS = GoldenTable.rows("m3_shadows");

    @Test
    void lightComesFromTheRetardedPlace() {
        assertThat(Worst.of(LAMPS, row -> {
                    Event emission = new LampWay(row).emission();
                    return Math.max(
                            MovingQuantity.share(row, row.distance(emission.position(), "e_"), "e"),
                            MovingQuantity.share(row, row.difference(emission.time(), "et"), "et"));
                }))
                .matches(Worst::passes);
    }

    @Test
    void lightComesAlongItsDirection() {
        assertThat(Worst.of(LAMPS, row -> {
                    Vector3d direction = new LampWay(row).direction();
                    double cosine = Vectors.unit(row.vector("n_")).dot(direction);
                    return Math.max(
                            MovingQuantity.share(row, row.distance(direction, "dir_"), "dir"),
                            cosine * row.number("side") < 0
                                    ? Double.POSITIVE_INFINITY
                                    : MovingQuantity.share(row, row.difference(Math.abs(cosine), "cos"), "cos"));
                }))
                .matches(Worst::passes);
    }

    @Test
    void lightIsShifted() {
        List<GoldenRow> rows = LAMPS.stream().filter(row -> row.isNumber("D")).toList();
        assertThat(Worst.of(
                        rows,
                        row -> MovingQuantity.share(
                                row, row.difference(new LampWay(row).atSurface.dopplerFactor, "D"), "D")))
                .matches(Worst::passes);
    }

    @Test
    void lightIsAsLongOnItsWayInEachFrame() {
        List<GoldenRow> rows =
                LAMPS.stream().filter(row -> row.isNumber("r_surface")).toList();
        assertThat(Worst.of(rows, row -> {
                    LampWay way = new LampWay(row);
                    // the hit in the frame of the lamp is rounded, as its place and its time
                    double limit = 4 * U * (row.number("acond_et") + row.number("acond_D"));
                    return Math.max(
                            Worst.share(row.relativeDifference(way.lengthInScene(), "r_scene"), limit),
                            Worst.share(
                                    row.relativeDifference(way.length() / way.atSurface.dopplerFactor, "r_lamp"),
                                    limit));
                }))
                .matches(Worst::passes);
    }

    @Test
    void shadowsFallWhereTheyMust() {
        assertThat(Worst.of(decidable(), row -> {
                    Shadow shadow = new Shadow(row);
                    return shadow.isBlocked == row.has("blocked", "1") ? 0 : Double.POSITIVE_INFINITY;
                }))
                .matches(Worst::passes);
    }

    private static List<GoldenRow> decidable() {
        return SHADOWS.stream()
                .filter(row -> row.number("decidable_eps") >= 16 * U)
                .toList();
    }

    @Test
    void lightIsStoppedAtItsEvent() {
        List<GoldenRow> rows =
                decidable().stream().filter(row -> row.has("blocked", "1")).toList();
        assertThat(Worst.of(rows, row -> {
                    FoundHit stop = new Shadow(row).stop;
                    double share = stop.lambda() / new Shadow(row).length;
                    return Math.max(
                            MovingQuantity.share(row, row.difference(share, "share"), "share"),
                            MovingQuantity.share(row, row.distance(stop.own().position(), "k_"), "k"));
                }))
                .matches(Worst::passes);
    }

    /** The light of the lamp of a row on its way to a place at rest. */
    private static final class Shadow {
        final boolean isBlocked;
        final double length;
        final FoundHit stop;

        Shadow(GoldenRow row) {
            MovingRow scene = MovingRow.lit(
                    List.of(MovingRow.moving(row.vector("vo_"), row.vector("po_"), 0, MovingRow.shape(row, "_"))),
                    row.vector("vl_"),
                    row.vector("p_"),
                    row.vector("q_"),
                    false);
            Hit hit = Hit.blank();
            Vector3d x = row.vector("x_");
            hit.setPlace(0, x.x, x.y, x.z, row.number("t"));
            hit.eventMemory().setPlace(0, x.x, x.y, x.z, row.number("t"));
            Sightline sight = new Sightline();
            Lighting ways = scene.retardedLight();
            if (!ways.find(0, hit, sight)) {
                throw new IllegalStateException("no light");
            }
            isBlocked = !ways.isClear(0, hit, sight);
            Vector3d to = new Vector3d(sight.x, sight.y, sight.z);
            length = to.length();
            to.div(length);
            stop = scene.find(Ray.from(x.x, x.y, x.z, to.x, to.y, to.z, row.number("t")));
        }
    }
}
