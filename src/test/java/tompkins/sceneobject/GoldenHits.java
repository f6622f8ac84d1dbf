package tompkins.sceneobject;

import static tompkins.golden.GoldenTable.U;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;
import org.joml.Vector3d;
import tompkins.golden.GoldenRow;
import tompkins.golden.Worst;

/** Distances of hits compared with the reference data. */
public final class GoldenHits {

    /** The file of the reference data. */
    public static final String FILE = "f_hits";

    private static final double LIMIT = 4;

    private GoldenHits() {}

    /** The row on which a method does worst. */
    public static Worst worst(List<GoldenRow> rows, HitMethod method) {
        return Worst.of(rows, row -> excess(row, method));
    }

    private static double excess(GoldenRow row, HitMethod method) {
        boolean fromItself = row.text("class").startsWith("self_");
        BigDecimal expected = expected(row, fromItself);
        double distance = distance(row, method, fromItself);
        if (expected == null || distance == Double.POSITIVE_INFINITY) {
            boolean same = expected == null && distance == Double.POSITIVE_INFINITY;
            return same || !isDecidable(row) ? 0 : Double.POSITIVE_INFINITY;
        }
        if (!Double.isFinite(distance)) {
            return Double.NaN;
        }
        double error = new BigDecimal(distance).subtract(expected).abs().doubleValue();
        return Worst.share(error, tolerance(row));
    }

    private static double tolerance(GoldenRow row) {
        double ku = LIMIT * U;
        double conditioned = ku * row.number("tol_per_eps");
        if (row.isNumber("tol_per_sqrt_eps")) {
            conditioned = Math.min(conditioned, Math.sqrt(ku) * row.number("tol_per_sqrt_eps"));
        }
        return ku * row.number("t_scale") + conditioned;
    }

    private static boolean isDecidable(GoldenRow row) {
        return !(row.number("decidable_eps") < 16 * U) && !(row.number("finite_margin") < 16 * U);
    }

    private static double distance(GoldenRow row, HitMethod method, boolean fromItself) {
        Vector3d origin = row.vector("o");
        Vector3d direction = row.vector("d");
        Vector3d point = row.vector("p");
        return switch (row.text("shape")) {
            case "sphere" -> method.sphere(origin, direction, point, row.number("R"), fromItself);
            case "plane" -> method.plane(origin, direction, point, row.vector("n"));
            default -> method.cylinder(origin, direction, point, row.vector("p2"), row.number("R"), fromItself);
        };
    }

    /** The exact distance of the first hit on the piece that is there, or null if there is none. */
    private static BigDecimal expected(GoldenRow row, boolean fromItself) {
        if (fromItself) {
            return row.isNumber("t_next_from_surface") && withinEnds(row, row.exact("t_next_from_surface"))
                    ? row.exact("t_next_from_surface")
                    : null;
        }
        if (!row.has("shape", "cylinder")) {
            return row.has("hit", "1") ? row.exact("t_first") : null;
        }
        for (String root : List.of("t_near", "t_far")) {
            if (row.isNumber(root) && row.exact(root).signum() > 0 && withinEnds(row, row.exact(root))) {
                return row.exact(root);
            }
        }
        return null;
    }

    /** Whether a hit lies between the ends; the reference also has cylinders without ends, the program has none. */
    private static boolean withinEnds(GoldenRow row, BigDecimal distance) {
        if (!row.has("shape", "cylinder")) {
            return true;
        }
        BigDecimal along = BigDecimal.ZERO;
        BigDecimal squared = BigDecimal.ZERO;
        for (String axis : List.of("x", "y", "z")) {
            BigDecimal start = new BigDecimal(row.number("p" + axis));
            BigDecimal span = new BigDecimal(row.number("p2" + axis)).subtract(start);
            BigDecimal offset = new BigDecimal(row.number("o" + axis))
                    .add(distance.multiply(new BigDecimal(row.number("d" + axis))))
                    .subtract(start);
            along = along.add(offset.multiply(span));
            squared = squared.add(span.multiply(span));
        }
        double share = along.divide(squared, MathContext.DECIMAL64).doubleValue();
        return share >= 0 && share <= 1;
    }
}
