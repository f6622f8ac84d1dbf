package tompkins.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.golden.GoldenRow;
import tompkins.golden.GoldenTable;
import tompkins.property.Descriptions;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.ray.RayPacket;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.shutter.ArbitraryPlaneShutter;
import tompkins.shutter.DetectorPlaneShutter;
import tompkins.shutter.FixedPointSurfaceShutter;
import tompkins.shutter.FocusSurfaceShutter;
import tompkins.shutter.LensHologramShutter;
import tompkins.shutter.RollingShutter;
import tompkins.shutter.Shutter;
import tompkins.shutter.SweepDirection;
import tompkins.spacetime.SpaceTimeTransformation;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;

/** When the lines of a picture open and close, for every model of the shutter and both cameras. */
class ShutterDelaysTest {

    private static final SpaceTimeTransformation MOVING =
            TransformationLaw.LORENTZ.sceneFromCamera(Velocity.of(0.3, 0.1, 0.5));

    private static RollingShutter rolling(GoldenRow row) {
        SweepDirection direction = SweepDirection.valueOf(row.text("direction").toUpperCase(Locale.ROOT));
        return new RollingShutter(direction, row.number("sweep"));
    }

    static Stream<GoldenRow> rows() {
        return GoldenTable.rows("m8_rolling").stream();
    }

    private static Camera slow(Camera instant, double exposure, RollingShutter rolling) {
        return Descriptions.with(Descriptions.with(instant, "exposureTime", exposure), "rollingShutter", rolling);
    }

    @ParameterizedTest
    @MethodSource("rows")
    void linesOpenAndCloseAsTheReferenceSays(GoldenRow row) {
        Camera camera = slow(
                ThinLensCamera.DEFAULT.withShutter(new AperturePlaneShutter(row.number("opening_time"))),
                row.number("exposure"),
                rolling(row));
        double tolerance = 4 * GoldenTable.U * (Math.abs(row.number("closes")) + row.number("sweep"));
        assertThat(row.difference(time(camera, row, 0), "opens")).isLessThanOrEqualTo(tolerance);
        assertThat(row.difference(time(camera, row, 1), "closes")).isLessThanOrEqualTo(tolerance);
    }

    private static double time(Camera camera, GoldenRow row, double moment) {
        int lines = (int) row.number("lines");
        boolean rows = rolling(row).direction().runsOverRows();
        double line = row.number("line") + 0.9;
        CameraRays rays = camera.rays(rows ? 3 : lines, rows ? lines : 3, MOVING);
        return ray(rays, rows ? 1.2 : line, rows ? line : 1.2, 0, moment).time;
    }

    private static Ray ray(CameraRays rays, double x, double y, double lensX, double moment) {
        RayPacket made = new RayPacket(1);
        rays.make(SamplePositions.single(x, y, lensX, 0.2, moment), made, new RayCounts());
        return made.ray(0);
    }

    static Stream<Camera> cameras() {
        List<Shutter> shutters = List.of(
                new AperturePlaneShutter(0.3),
                new DetectorPlaneShutter(1.1, 1),
                new LensHologramShutter(1.1, 1),
                new FocusSurfaceShutter(-9.5),
                new FixedPointSurfaceShutter(),
                new ArbitraryPlaneShutter(-1, new Vector3d(0, 0, 1), new Vector3d(0.3, 0.2, 1)));
        Camera there = Descriptions.with(ThinLensCamera.DEFAULT, "position", new Vector3d(1, 2, 3));
        Camera aside = Descriptions.with(there, "viewDirection", new Vector3d(0.1, 0, 1));
        Camera wide =
                Descriptions.with(Descriptions.with(aside, "horizontalAngleDegrees", 60.0), "apertureRadius", 0.4);
        return Stream.of(ThinLensCamera.DEFAULT, wide, PanoramicCamera.DEFAULT)
                .flatMap(camera -> shutters.stream().map(camera::withShutter));
    }

    /** The six formulas stay: whatever they say, a line opens later by its share of the sweep. */
    @ParameterizedTest
    @MethodSource("cameras")
    void everyModelOpensLaterByLineAndMoment(Camera instant) {
        CameraRays plain = instant.rays(40, 20, MOVING);
        CameraRays left =
                slow(instant, 3, new RollingShutter(SweepDirection.LEFT, 8)).rays(40, 20, MOVING);
        for (double moment : new double[] {0, 0.25, 1}) {
            Ray before = ray(plain, 7.9, 3.1, 0.5, moment);
            Ray after = ray(left, 7.9, 3.1, 0.5, moment);
            // column 7 is the 33rd from the right of 40
            assertThat(after.time - before.time).isCloseTo(8 * 32.5 / 40 + 3 * moment, within(1e-13));
            assertThat(after.x).isEqualTo(before.x);
            assertThat(after.dx).isEqualTo(before.dx);
            assertThat(after.dz).isEqualTo(before.dz);
        }
    }

    /** All of a pixel opens with its line; the lower edge of the picture belongs to the last one. */
    @ParameterizedTest
    @MethodSource("cameras")
    void allOfALineOpensTogether(Camera instant) {
        CameraRays down = slow(
                        instant.withShutter(AperturePlaneShutter.DEFAULT),
                        instant.exposureTime(),
                        new RollingShutter(SweepDirection.DOWN, 2))
                .rays(4, 10, MOVING);
        assertThat(ray(down, 0.1, 6.01, 0, 0.5).time)
                .isEqualTo(ray(down, 3.9, 6.99, 0.3, 0.5).time)
                .isCloseTo(1.3, within(1e-15));
        assertThat(ray(down, 1, 10, 0, 0).time).isCloseTo(1.9, within(1e-15));
    }
}
