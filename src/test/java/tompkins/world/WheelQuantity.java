package tompkins.world;

import static tompkins.golden.GoldenTable.U;

import java.util.function.BiFunction;
import org.joml.Vector3d;
import tompkins.golden.GoldenRow;
import tompkins.golden.Worst;
import tompkins.math.Vectors;
import tompkins.ray.Ray;

/** What the reference data tell of hits on what turns, each within 4 u of its condition. */
enum WheelQuantity {
    LAMBDA("lambda", (row, wheel) -> row.difference(wheel.lambda, "lambda")),
    CAMERA_PLACE("cam", (row, wheel) -> {
        Vector3d place = Vectors.unit(row.vector("cam_")).mul(wheel.lambda);
        return row.distance(place, "cam_");
    }),
    CAMERA_VELOCITY("vel", (row, wheel) -> row.distance(wheel.velocityInCamera(), "vel_")),
    SCENE_PLACE("s", (row, wheel) -> row.distance(wheel.inScene().position(), "s_")),
    SCENE_TIME("st", (row, wheel) -> row.difference(wheel.inScene().time(), "st")),
    FRAME_PLACE("k", (row, wheel) -> row.distance(wheel.inFrame().position(), "k_")),
    FRAME_TIME("ktau", (row, wheel) -> row.difference(wheel.inFrame().time(), "ktau")),
    OWN_TIME("tau", (row, wheel) -> row.difference(wheel.own().time(), "tau")),
    READING("tau", (row, wheel) -> row.difference(wheel.reading(), "reading")),
    MATERIAL_PLACE("q", (row, wheel) -> row.distance(wheel.own().position(), "q_")),
    VELOCITY("V", (row, wheel) -> row.distance(wheel.velocity(), "V_")),
    NORMAL("n", (row, wheel) -> row.distance(wheel.normal, "n_")),
    POINT_NORMAL("np", (row, wheel) -> row.distance(wheel.pointNormal, "np_")),
    FRAME_DIRECTION("kd", (row, wheel) -> {
        double length = wheel.measures ? wheel.found.ray.directionLength : 1;
        return row.distance(wheel.found.ownDirection().mul(length), "kd_");
    }),
    POINT_DIRECTION("pd", (row, wheel) -> row.distance(direction(wheel.inPoint), "pd_")),
    DOPPLER_FACTOR("D", (row, wheel) -> row.difference(1 / wheel.inPoint.frequency, "D")),
    COSINE(
            "cos_incidence",
            (row, wheel) -> row.difference(Math.abs(direction(wheel.inPoint).dot(wheel.pointNormal)), "cos_incidence")),
    MIRRORED("rk", (row, wheel) -> row.distance(direction(wheel.mirrored).mul(wheel.mirrored.directionLength), "rk_")),
    MIRRORED_IN_SCENE("rs", (row, wheel) -> row.distance(direction(mirroredInScene(wheel)), "rs_")),
    MIRRORED_FREQUENCY("rratio", (row, wheel) -> {
        Ray before = wheel.scene.routes.transform(wheel.found.ray, 0, Ray.blank());
        return row.difference(mirroredInScene(wheel).frequency / before.frequency, "rratio");
    }),
    LAMP_DIRECTION("ld", (row, wheel) -> row.distance(direction(wheel.toLamp()), "ld_")),
    LAMP_FREQUENCY("D1", (row, wheel) -> row.difference(wheel.toLamp().frequency, "D1")),
    LAMP_COSINE("lcos", (row, wheel) -> row.difference(direction(wheel.toLamp()).dot(wheel.pointNormal), "lcos"));

    private final String column;
    private final BiFunction<GoldenRow, Wheel, Double> error;

    WheelQuantity(String column, BiFunction<GoldenRow, Wheel, Double> error) {
        this.column = column;
        this.error = error;
    }

    private static Ray mirroredInScene(Wheel wheel) {
        return wheel.scene.routes.transform(wheel.mirrored, 0, Ray.blank());
    }

    private static Vector3d direction(Ray ray) {
        return new Vector3d(ray.dx, ray.dy, ray.dz);
    }

    private boolean isGiven(GoldenRow row) {
        return row.isNumber("acond_" + column);
    }

    /** The largest excess of the quantity over a row: infinite if something is hit that should not be, or not. */
    double excess(GoldenRow row) {
        Wheel wheel = new Wheel(row);
        boolean isHit = !row.has("hit", "0");
        if (wheel.found == null || !isHit) {
            boolean decidable = !row.isNumber("decidable_eps") || row.number("decidable_eps") >= 16 * U;
            return (wheel.found == null) == !isHit || !decidable ? 0 : Double.POSITIVE_INFINITY;
        }
        // what does not turn is described where it is
        if (!isGiven(row) || this == MATERIAL_PLACE && row.number("omega") == 0) {
            return 0;
        }
        return Worst.share(
                error.apply(row, wheel),
                4 * U * (row.number("acond_" + column) + (this == READING ? Math.abs(row.number("tau0")) : 0)));
    }
}
