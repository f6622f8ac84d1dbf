package tompkins.sceneobject;

import static tompkins.golden.GoldenTable.U;

import java.util.List;
import org.joml.Vector3d;
import tompkins.golden.GoldenRow;
import tompkins.golden.GoldenTable;
import tompkins.golden.Worst;

/** Hits of cones and boxes compared with the reference data. */
public final class GoldenSolids {

    /** The file of the reference data. */
    public static final String FILE = "h_cones_boxes";

    private GoldenSolids() {}

    /** The row on which a method does worst with the distance. */
    public static Worst worstDistance(List<GoldenRow> rows, HitMethod method) {
        return Worst.of(rows, row -> {
            double distance = distance(row, method);
            boolean misses = distance == Double.POSITIVE_INFINITY;
            if (misses || !row.isNumber("t")) {
                return misses == row.isNumber("t") ? Double.POSITIVE_INFINITY : 0;
            }
            return Worst.share(row.difference(distance, "t"), U * row.number("acond_t"));
        });
    }

    /** The row on which a method does worst with the normal of a cone, where it finds the hit. */
    public static Worst worstNormal(HitMethod method) {
        return Worst.of(GoldenTable.rows(FILE, row -> row.isNumber("nx")), row -> {
            Vector3d normal = method.coneNormal(
                    row.vector("o"),
                    row.vector("d"),
                    row.vector("p"),
                    row.vector("q"),
                    row.number("R"),
                    distance(row, method));
            return Worst.share(row.distance(normal, "n"), U * row.number("acond_n"));
        });
    }

    private static double distance(GoldenRow row, HitMethod method) {
        Vector3d origin = row.vector("o");
        Vector3d direction = row.vector("d");
        if (row.has("shape", "box")) {
            return method.box(origin, direction, row.vector("p"), row.vector("q"));
        }
        boolean fromItself = row.text("class").startsWith("self_");
        return method.cone(origin, direction, row.vector("p"), row.vector("q"), row.number("R"), fromItself);
    }
}
