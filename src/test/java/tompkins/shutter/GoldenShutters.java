package tompkins.shutter;

import static tompkins.golden.GoldenTable.U;

import java.util.List;
import org.joml.Vector3d;
import tompkins.golden.GoldenRow;
import tompkins.golden.GoldenTable;
import tompkins.golden.Worst;
import tompkins.math.Vectors;
import tompkins.spacetime.SpaceTimeTransformation;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;

/** Times of shutters compared with the reference data. */
public final class GoldenShutters {

    private GoldenShutters() {}

    /** The row of a model on which the program does worst. */
    public static Worst worst(String model) {
        return Worst.of(
                rows(model), row -> excess(row, shutter(row).transmissionTime(lensRay(row), sceneFromCamera(row))));
    }

    /** The row on which the naive form does worst, for the two models that have one. */
    public static Worst worstNaive(String model) {
        return Worst.of(
                rows(model),
                row -> excess(row, model.equals("fixed_point") ? naiveFixedPoint(row) : naiveIdealLens(row)));
    }

    private static List<GoldenRow> rows(String model) {
        return GoldenTable.rows("b_shutter_times", row -> row.has("model", model));
    }

    private static double naiveIdealLens(GoldenRow row) {
        return NaiveShutters.idealLens(
                row.number("t0"),
                row.number("detector_distance"),
                row.vector("c"),
                row.vector("v"),
                row.vector("e"),
                row.vector("i"));
    }

    private static double naiveFixedPoint(GoldenRow row) {
        return NaiveShutters.fixedPoint(row.vector("beta_", "_hex"), row.vector("e"), row.vector("i"), side(row));
    }

    private static double excess(GoldenRow row, double time) {
        return Worst.share(row.difference(time, "t_aperture"), 4 * U * row.number("acond_t"));
    }

    private static Shutter shutter(GoldenRow row) {
        double openingTime = row.number("t0");
        double detectorDistance = row.number("detector_distance");
        return switch (row.text("model")) {
            case "aperture_plane" -> new AperturePlaneShutter(openingTime);
            case "arbitrary_plane" -> new ArbitraryPlaneShutter(openingTime, row.vector("q"), row.vector("n"));
            case "detector_hologram" -> new LensHologramShutter(openingTime, detectorDistance);
            case "detector_ideal", "detector_infinity" -> new DetectorPlaneShutter(openingTime, detectorDistance);
            case "fixed_point" -> FixedPointSurfaceShutter.DEFAULT;
            case "focus_surface" -> new FocusSurfaceShutter(openingTime);
            default -> throw new IllegalArgumentException(row.text("model"));
        };
    }

    private static SpaceTimeTransformation sceneFromCamera(GoldenRow row) {
        return TransformationLaw.LORENTZ.sceneFromCamera(Velocity.of(row.vector("beta_", "_hex")));
    }

    private static double side(GoldenRow row) {
        return row.has("image_in_front", "1") ? 1 : -1;
    }

    private static LensRay lensRay(GoldenRow row) {
        Vector3d centre = row.vector("c");
        Vector3d view = Vectors.unit(row.vector("v"));
        if (row.has("model", "detector_infinity")) {
            return new LensRay(centre, row.vector("e"), Vectors.unit(row.vector("i")), 0, view);
        }
        Vector3d toImage = row.vector("i").sub(centre);
        double inverse = side(row) / toImage.length();
        return new LensRay(centre, row.vector("e"), Vectors.unit(toImage).mul(side(row)), inverse, view);
    }
}
