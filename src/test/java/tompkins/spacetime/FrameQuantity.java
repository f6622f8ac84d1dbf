package tompkins.spacetime;

import static tompkins.golden.GoldenTable.U;

import java.util.function.ToDoubleBiFunction;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.golden.GoldenRow;
import tompkins.golden.GoldenTable;
import tompkins.golden.Worst;

/** The quantities of a change of frame that the reference data hold, each with its limit. */
public enum FrameQuantity {
    GAMMA("4 u", (method, row) -> Worst.share(row.relativeDifference(method.gamma(beta(row)), "gamma"), 4 * U)),
    GAMMA_MINUS_ONE("16 u", (method, row) -> {
        boolean subnormal = beta(row).length() < 1e-145;
        return subnormal || row.number("gamma_minus_1") == 0
                ? 0
                : row.relativeDifference(method.gammaMinusOne(beta(row)), "gamma_minus_1") / (16 * U);
    }),
    PLACE("4 u acond", (method, row) -> {
        Vector3d place = method.event(beta(row), event(row)).position();
        return Worst.share(row.distance(place, "xp", "yp", "zp"), 4 * U * row.number("acond_x_u"));
    }),
    TIME("4 u acond", (method, row) -> {
        double time = method.event(beta(row), event(row)).time();
        return Worst.share(row.difference(time, "tp"), 4 * U * row.number("acond_t_u"));
    }),
    PLACE_BACK("4 u acond", (method, row) -> {
        Vector3d place = method.event(beta(row).negate(), event(row)).position();
        return Worst.share(row.distance(place, "inv_"), 4 * U * row.number("acond_ix_u"));
    }),
    TIME_BACK("4 u acond", (method, row) -> {
        double time = method.event(beta(row).negate(), event(row)).time();
        return Worst.share(row.difference(time, "inv_t"), 4 * U * row.number("acond_it_u"));
    }),
    DIRECTION(
            "8 gamma u",
            (method, row) -> row.distance(turned(method, beta(row), direction(row)), "dph") / directionLimit(row)),
    DIRECTION_BACK(
            "8 gamma u",
            (method, row) ->
                    row.distance(turned(method, beta(row).negate(), direction(row)), "inv_dh") / directionLimit(row)),
    FREQUENCY_RATIO("8 gamma u", (method, row) -> {
        double ratio = method.direction(beta(row), direction(row), new Vector3d());
        return row.relativeDifference(ratio, "dp_len") / directionLimit(row);
    }),
    FREQUENCY_RATIO_BACK("8 gamma u", (method, row) -> {
        double ratio = method.direction(beta(row).negate(), direction(row), new Vector3d());
        return row.relativeDifference(ratio, "inv_d_len") / directionLimit(row);
    }),
    ROUND_TRIP_OF_EVENTS("32 gamma^2 u", (method, row) -> {
        Event event = event(row);
        Event back = method.event(beta(row).negate(), method.event(beta(row), event));
        double error = Math.hypot(back.position().distance(event.position()), back.time() - event.time());
        double size = Math.hypot(event.position().length(), event.time());
        double gamma = row.number("gamma");
        return Worst.share(error, 32 * gamma * gamma * U * size);
    }),
    ROUND_TRIP_OF_DIRECTIONS("16 gamma u", (method, row) -> {
        Vector3d start = direction(row).normalize();
        Vector3d back = turned(method, beta(row).negate(), turned(method, beta(row), start));
        return back.distance(start) / (2 * directionLimit(row));
    }),
    WINDOW("8 (gamma_w + gamma) u", (method, row) -> row.distance(behindWindow(method, row), "w") / windowLimit(row)),
    WINDOW_AND_CAMERA(
            "8 (gamma_w + gamma) u",
            (method, row) -> row.distance(turned(method, row.vector("bc_", "_hex"), behindWindow(method, row)), "out")
                    / windowLimit(row));

    private final String limit;
    private final ToDoubleBiFunction<FrameMethod, GoldenRow> excess;

    FrameQuantity(String limit, ToDoubleBiFunction<FrameMethod, GoldenRow> excess) {
        this.limit = limit;
        this.excess = excess;
    }

    /** The limit in words. */
    public String limit() {
        return limit;
    }

    /** The row on which a method does worst. */
    public Worst worst(FrameMethod method) {
        String file = name().startsWith("WINDOW") ? "c_lorentz_window" : "a_events_directions";
        return Worst.of(GoldenTable.rows(file), row -> excess.applyAsDouble(method, row));
    }

    private static Vector3d turned(FrameMethod method, Vector3dc beta, Vector3dc direction) {
        Vector3d result = new Vector3d();
        method.direction(beta, direction, result);
        return result;
    }

    private static double directionLimit(GoldenRow row) {
        return 8 * U * row.number("gamma");
    }

    private static Vector3d behindWindow(FrameMethod method, GoldenRow row) {
        return turned(method, row.vector("bw_", "_hex").negate(), row.vector("d"));
    }

    private static double windowLimit(GoldenRow row) {
        return 8 * U * (gammaOf(row, "bw_") + gammaOf(row, "bc_"));
    }

    private static Vector3d beta(GoldenRow row) {
        return row.vector("beta_", "_hex");
    }

    private static Vector3d direction(GoldenRow row) {
        return row.vector("d");
    }

    private static Event event(GoldenRow row) {
        return new Event(row.number("x"), row.number("y"), row.number("z"), row.number("t"));
    }

    /** Only for limits, so that its own accuracy does not matter. */
    private static double gammaOf(GoldenRow row, String prefix) {
        return Velocity.of(row.vector(prefix, "_hex")).gamma();
    }
}
