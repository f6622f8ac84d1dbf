package tompkins.golden;

import java.math.BigDecimal;
import java.util.Map;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** One row of the reference data. Inputs are read as doubles, results with all their digits. */
public final class GoldenRow {

    private final Map<String, String> cells;

    GoldenRow(Map<String, String> cells) {
        this.cells = cells;
    }

    /** The row's name. */
    public String id() {
        return text("id");
    }

    /** The cell as it is written. */
    public String text(String column) {
        String cell = cells.get(column);
        if (cell == null) {
            throw new IllegalArgumentException("no column " + column);
        }
        return cell;
    }

    /** Whether a cell holds exactly this text. */
    public boolean has(String column, String value) {
        return text(column).equals(value);
    }

    /** Whether the cell holds a number. */
    public boolean isNumber(String column) {
        return !text(column).isEmpty() && !text(column).equals("nan");
    }

    /** The cell as a double; NaN for {@code nan}. */
    public double number(String column) {
        return Double.parseDouble(text(column).equals("nan") ? "NaN" : text(column));
    }

    /** The cell with all its digits. */
    public BigDecimal exact(String column) {
        return new BigDecimal(text(column));
    }

    /** The three columns {@code prefix + x}, {@code prefix + y}, {@code prefix + z}, each followed by a suffix. */
    public Vector3d vector(String prefix, String suffix) {
        return new Vector3d(
                number(prefix + "x" + suffix), number(prefix + "y" + suffix), number(prefix + "z" + suffix));
    }

    /** The three columns {@code prefix + x}, {@code prefix + y}, {@code prefix + z}. */
    public Vector3d vector(String prefix) {
        return vector(prefix, "");
    }

    /** Distance of a vector from the reference in three columns. */
    public double distance(Vector3dc value, String columnX, String columnY, String columnZ) {
        return Math.hypot(
                Math.hypot(difference(value.x(), columnX), difference(value.y(), columnY)),
                difference(value.z(), columnZ));
    }

    /** Distance of a vector from the columns {@code prefix + x}, {@code prefix + y}, {@code prefix + z}. */
    public double distance(Vector3dc value, String prefix) {
        return distance(value, prefix + "x", prefix + "y", prefix + "z");
    }

    /** What a value lacks to the reference in a column; infinite if the value is not finite. */
    public double difference(double value, String column) {
        return Double.isFinite(value)
                ? new BigDecimal(value).subtract(exact(column)).abs().doubleValue()
                : Double.POSITIVE_INFINITY;
    }

    /** The relative difference from the reference in a column. */
    public double relativeDifference(double value, String column) {
        return difference(value, column) / Math.abs(number(column));
    }
}
