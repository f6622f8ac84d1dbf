package tompkins.spacetime;

import static tompkins.golden.GoldenTable.U;

import java.util.function.ToDoubleFunction;
import org.joml.Vector3d;
import tompkins.golden.GoldenRow;
import tompkins.golden.GoldenTable;
import tompkins.golden.Worst;

/** The quantities of a change of frame that the reference data hold, each with its limit. */
public enum FrameQuantity {
    GAMMA("a_events_directions", "4 u") {
        @Override
        double excess(FrameMethod method, GoldenRow row) {
            return Worst.share(row.relativeDifference(method.gamma(beta(row)), "gamma"), 4 * U);
        }
    },
    GAMMA_MINUS_ONE("a_events_directions", "16 u") {
        @Override
        double excess(FrameMethod method, GoldenRow row) {
            boolean subnormal = beta(row).length() < 1e-145;
            return subnormal || row.number("gamma_minus_1") == 0
                    ? 0
                    : row.relativeDifference(method.gammaMinusOne(beta(row)), "gamma_minus_1") / (16 * U);
        }
    },
    PLACE("a_events_directions", "4 u acond") {
        @Override
        double excess(FrameMethod method, GoldenRow row) {
            Vector3d place = method.event(beta(row), event(row)).position();
            return Worst.share(row.distance(place, "xp", "yp", "zp"), 4 * U * row.number("acond_x_u"));
        }
    },
    TIME("a_events_directions", "4 u acond") {
        @Override
        double excess(FrameMethod method, GoldenRow row) {
            double time = method.event(beta(row), event(row)).time();
            return Worst.share(row.difference(time, "tp"), 4 * U * row.number("acond_t_u"));
        }
    },
    PLACE_BACK("a_events_directions", "4 u acond") {
        @Override
        double excess(FrameMethod method, GoldenRow row) {
            Vector3d place = method.event(beta(row).negate(), event(row)).position();
            return Worst.share(row.distance(place, "inv_"), 4 * U * row.number("acond_ix_u"));
        }
    },
    TIME_BACK("a_events_directions", "4 u acond") {
        @Override
        double excess(FrameMethod method, GoldenRow row) {
            double time = method.event(beta(row).negate(), event(row)).time();
            return Worst.share(row.difference(time, "inv_t"), 4 * U * row.number("acond_it_u"));
        }
    },
    DIRECTION("a_events_directions", "8 gamma u") {
        @Override
        double excess(FrameMethod method, GoldenRow row) {
            Vector3d direction = new Vector3d();
            method.direction(beta(row), direction(row), direction);
            return row.distance(direction, "dph") / (8 * U * row.number("gamma"));
        }
    },
    DIRECTION_BACK("a_events_directions", "8 gamma u") {
        @Override
        double excess(FrameMethod method, GoldenRow row) {
            Vector3d direction = new Vector3d();
            method.direction(beta(row).negate(), direction(row), direction);
            return row.distance(direction, "inv_dh") / (8 * U * row.number("gamma"));
        }
    },
    FREQUENCY_RATIO("a_events_directions", "8 gamma u") {
        @Override
        double excess(FrameMethod method, GoldenRow row) {
            double ratio = method.direction(beta(row), direction(row), new Vector3d());
            return row.relativeDifference(ratio, "dp_len") / (8 * U * row.number("gamma"));
        }
    },
    FREQUENCY_RATIO_BACK("a_events_directions", "8 gamma u") {
        @Override
        double excess(FrameMethod method, GoldenRow row) {
            double ratio = method.direction(beta(row).negate(), direction(row), new Vector3d());
            return row.relativeDifference(ratio, "inv_d_len") / (8 * U * row.number("gamma"));
        }
    },
    ROUND_TRIP_OF_EVENTS("a_events_directions", "32 gamma^2 u") {
        @Override
        double excess(FrameMethod method, GoldenRow row) {
            Event event = event(row);
            Event back = method.event(beta(row).negate(), method.event(beta(row), event));
            double error = Math.hypot(back.position().distance(event.position()), back.time() - event.time());
            double size = Math.hypot(event.position().length(), event.time());
            double gamma = row.number("gamma");
            return Worst.share(error, 32 * gamma * gamma * U * size);
        }
    },
    ROUND_TRIP_OF_DIRECTIONS("a_events_directions", "16 gamma u") {
        @Override
        double excess(FrameMethod method, GoldenRow row) {
            Vector3d start = direction(row).normalize();
            Vector3d there = new Vector3d();
            method.direction(beta(row), start, there);
            method.direction(beta(row).negate(), there, there);
            return there.distance(start) / (16 * U * row.number("gamma"));
        }
    },
    WINDOW("c_lorentz_window", "8 (gamma_w + gamma) u") {
        @Override
        double excess(FrameMethod method, GoldenRow row) {
            Vector3d direction = new Vector3d();
            method.direction(row.vector("bw_", "_hex").negate(), row.vector("d"), direction);
            return row.distance(direction, "w") / (8 * U * (gammaOf(row, "bw_") + gammaOf(row, "bc_")));
        }
    },
    WINDOW_AND_CAMERA("c_lorentz_window", "8 (gamma_w + gamma) u") {
        @Override
        double excess(FrameMethod method, GoldenRow row) {
            Vector3d direction = new Vector3d();
            method.direction(row.vector("bw_", "_hex").negate(), row.vector("d"), direction);
            method.direction(row.vector("bc_", "_hex"), direction, direction);
            return row.distance(direction, "out") / (8 * U * (gammaOf(row, "bw_") + gammaOf(row, "bc_")));
        }
    };

    private final String file;
    private final String limit;

    FrameQuantity(String file, String limit) {
        this.file = file;
        this.limit = limit;
    }

    /** The limit in words. */
    public String limit() {
        return limit;
    }

    /** Error of the method on a row, divided by the limit. */
    abstract double excess(FrameMethod method, GoldenRow row);

    /** The row on which a method does worst. */
    public Worst worst(FrameMethod method) {
        ToDoubleFunction<GoldenRow> excess = row -> excess(method, row);
        return Worst.of(GoldenTable.rows(file), excess);
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
