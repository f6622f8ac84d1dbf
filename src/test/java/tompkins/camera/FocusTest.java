package tompkins.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.property.Descriptions;
import tompkins.property.InvalidPropertyException;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.sceneobject.Disc;
import tompkins.sceneobject.Group;
import tompkins.sceneobject.Parallelogram;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.shutter.ArbitraryPlaneShutter;
import tompkins.shutter.DetectorPlaneShutter;
import tompkins.shutter.FixedPointSurfaceShutter;
import tompkins.shutter.FocusSurfaceShutter;
import tompkins.shutter.Shutter;
import tompkins.spacetime.IdentityTransformation;
import tompkins.surface.ColouredSurface;

/** Focus and shutters where an image point is far, nowhere, behind the lens or in it. */
class FocusTest {

    private static final double RADIUS = 0.1;

    private static CameraRays rays(SceneObject focus, Shutter shutter) {
        ThinLensCamera camera = Cameras.lens(
                new Vector3d(), new Vector3d(0, 0, 1), new Vector3d(0, 1, 0), 40, 0, RADIUS, focus, 0, shutter);
        return camera.rays(100, 100, new IdentityTransformation());
    }

    private static Plane plane(Vector3dc point, Vector3dc normal) {
        return new Plane("focus", point, normal, ColouredSurface.DEFAULT);
    }

    private static Ray ray(CameraRays rays, double x, double y, double lensX, double lensY) {
        RayCounts counts = new RayCounts();
        Ray ray = rays.ray(x, y, lensX, lensY, counts);
        assertThat(counts.withoutFocus + counts.withoutShutter).isZero();
        return ray;
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 1, 10, 1e6, 1e15, 1e300, -1, -10, -1e6, -1e15})
    void raysOfOnePixelMeetInThePointInFocus(double distance) {
        CameraRays rays =
                rays(plane(new Vector3d(0, 0, distance), new Vector3d(0, 0, 1)), AperturePlaneShutter.DEFAULT);
        Vector3dc chief = rays.chiefDirection(30, 80);
        // slopes: (x - lens)/distance = chief slope - lens/distance, wherever the plane is
        for (double lensX : new double[] {-1, 0.3, 1}) {
            Ray ray = ray(rays, 30, 80, lensX, 0);
            assertThat(ray.dz).isPositive();
            double expectedX = chief.x() / chief.z() - lensX * RADIUS / distance;
            assertThat(ray.dx / ray.dz).isCloseTo(expectedX, within(1e-15 * (1 + 1 / Math.abs(distance))));
            assertThat(ray.dy / ray.dz).isCloseTo(chief.y() / chief.z(), within(1e-15));
        }
    }

    @Test
    void focusAtInfinityMakesParallelRays() {
        // a floor, seen along its horizon
        CameraRays rays = rays(plane(new Vector3d(0, -1, 0), new Vector3d(0, 1, 0)), AperturePlaneShutter.DEFAULT);
        Ray left = ray(rays, 50, 50, -1, 0);
        Ray right = ray(rays, 50, 50, 1, 0.5);
        assertThat(left.dx).isEqualTo(right.dx).isZero();
        assertThat(left.dy).isEqualTo(right.dy).isZero();
    }

    @Test
    void missedFocusIsCountedAndAtInfinity() {
        Disc small = new Disc("focus", new Vector3d(0, 0, 10), new Vector3d(0, 0, 1), 0.1, ColouredSurface.DEFAULT);
        CameraRays rays = rays(small, new DetectorPlaneShutter(1, 1));
        RayCounts counts = new RayCounts();
        Ray hit = rays.ray(50, 50, 0.5, 0.5, counts);
        assertThat(counts.withoutFocus).isZero();
        assertThat(hit.dx).isNegative();
        Ray one = rays.ray(5, 5, -1, 0, counts);
        Ray other = rays.ray(5, 5, 1, 0, counts);
        assertThat(counts.withoutFocus).isEqualTo(2);
        assertThat(one.dx).isEqualTo(other.dx);
        assertThat(Double.isFinite(one.time + other.time)).isTrue();
    }

    @ParameterizedTest
    @ValueSource(doubles = {10, -10})
    void aPlaneInPiecesIsInFocusAsTheWhole(double distance) {
        Vector3d one = new Vector3d(1, 0, 0.25);
        Vector3d other = new Vector3d(0, 1, -0.125);
        List<SceneObject> pieces = new ArrayList<>();
        for (int i = 0; i < 400; i++) {
            Vector3d corner = new Vector3d(0, 0, distance).fma(i % 20 - 10, one).fma(i / 20 - 10, other);
            pieces.add(new Parallelogram("piece", corner, one, other, ColouredSurface.DEFAULT));
        }
        // farther away on the same side, and nearer behind what is seen in front
        pieces.add(plane(new Vector3d(0, 0, 3 * distance), new Vector3d(0, 0, 1)));
        if (distance > 0) {
            pieces.add(plane(new Vector3d(0, 0, -1), new Vector3d(0, 0, 1)));
        }
        Plane whole = plane(new Vector3d(0, 0, distance), one.cross(other, new Vector3d()));
        CameraRays expected = rays(whole, new DetectorPlaneShutter(1, 1));
        CameraRays rays = rays(new Group("", pieces), new DetectorPlaneShutter(1, 1));
        for (double x = 5.3; x < 100; x += 9) {
            Ray ray = ray(rays, x, 37 + x / 4, 0.4, -0.7);
            Ray sought = ray(expected, x, 37 + x / 4, 0.4, -0.7);
            assertThat(ray.dx / ray.dz).isCloseTo(sought.dx / sought.dz, within(1e-14));
            assertThat(ray.dy / ray.dz).isCloseTo(sought.dy / sought.dz, within(1e-14));
            assertThat(ray.time).isCloseTo(sought.time, within(1e-12));
        }
    }

    @Test
    void nothingInFocusIsCounted() {
        RayCounts counts = new RayCounts();
        assertThat(rays(new Group("", List.of()), AperturePlaneShutter.DEFAULT).ray(1, 2, 0.1, 0.2, counts))
                .isNotNull();
        assertThat(counts.withoutFocus).isEqualTo(1);
    }

    @Test
    void planeThroughTheLensIsRefused() {
        assertThatThrownBy(
                        () -> rays(plane(new Vector3d(1, 0, 0), new Vector3d(0, 1, 0)), AperturePlaneShutter.DEFAULT))
                .isInstanceOf(InvalidPropertyException.class)
                .hasMessageContaining("focus")
                .hasMessageContaining("lens centre");
    }

    @Test
    void focusAtInfinityHasNoTimeForShuttersThatNeedAPoint() {
        for (Shutter shutter : List.of(new FocusSurfaceShutter(0), FixedPointSurfaceShutter.DEFAULT)) {
            CameraRays rays = rays(plane(new Vector3d(0, -1, 0), new Vector3d(0, 1, 0)), shutter);
            RayCounts counts = new RayCounts();
            assertThat(rays.ray(50, 50, 0.5, 0, counts)).isNull();
            assertThat(counts.withoutShutter).isEqualTo(1);
            assertThat(rays.ray(50, 51, 0.5, 0, counts)).isNotNull();
        }
    }

    /** Such distances become times, from which no lamp could be seen. */
    @ParameterizedTest
    @ValueSource(doubles = {1, -1})
    void whatIsBeyondAllPlacesIsFocusedAtInfinity(double side) {
        Vector3d normal = new Vector3d(0, 0, 1);
        RayCounts counts = new RayCounts();
        Shutter shutter = new FocusSurfaceShutter(0);
        CameraRays near = rays(plane(new Vector3d(0, 0, side * 1e59), normal), shutter);
        assertThat(near.ray(50, 50, 0, 0, counts).time).isCloseTo(side * 1e59, withinPercentage(1e-10));
        CameraRays far = rays(plane(new Vector3d(0, 0, side * 1e61), normal), shutter);
        assertThat(far.ray(50, 50, 0, 0, counts)).isNull();
        assertThat(counts.withoutShutter).isEqualTo(1);
        assertThat(counts.withoutFocus).isZero();
    }

    @Test
    void shutterPlaneParallelToTheRayIsNeverCrossed() {
        Plane focus = plane(new Vector3d(0, 0, 10), new Vector3d(0, 0, 1));
        for (double height : new double[] {0, 1}) {
            CameraRays rays =
                    rays(focus, new ArbitraryPlaneShutter(0, new Vector3d(0, height, 0), new Vector3d(0, 1, 0)));
            RayCounts counts = new RayCounts();
            assertThat(rays.ray(50, 50, 0, 0, counts)).isNull();
            assertThat(counts.withoutShutter).isEqualTo(1);
            assertThat(rays.ray(50, 49, 0, 0, counts).time).isFinite();
        }
    }

    private static ThinLensCamera aside(SceneObject focus) {
        ThinLensCamera there = Descriptions.with(ThinLensCamera.DEFAULT, "position", new Vector3d(1, 2, 3));
        return Descriptions.with(Descriptions.with(there, "viewDirection", new Vector3d(0, 30, 40)), "focus", focus);
    }

    private static double inFocus(SceneObject object) {
        return FocusDistance.of(aside(object));
    }

    /** The view runs from (1, 2, 3) along (0, 0.6, 0.8). */
    @Test
    void theDistanceInFocusIsThatAlongTheMiddle() {
        assertThat(inFocus(plane(new Vector3d(0, 0, 11), new Vector3d(0, 0, 1))))
                .isCloseTo(10, within(1e-14));
        assertThat(inFocus(plane(new Vector3d(0, 0, -1), new Vector3d(0, 0, 1))))
                .as("behind the camera")
                .isCloseTo(-5, within(1e-14));
        assertThat(inFocus(new Sphere("ball", new Vector3d(1, 8, 11), 2, ColouredSurface.DEFAULT)))
                .as("the nearest point")
                .isCloseTo(8, within(1e-14));
        assertThat(inFocus(new Sphere("ball", new Vector3d(9, 8, 11), 2, ColouredSurface.DEFAULT)))
                .as("nothing there")
                .isNotFinite();
        assertThat(inFocus(plane(new Vector3d(2, 0, 0), new Vector3d(1, 0, 0))))
                .as("at infinity")
                .isInfinite();
    }

    @Test
    void aThinLensIsFocusedOnThePlaneAcrossItsView() {
        ThinLensCamera focused = (ThinLensCamera) FocusDistance.with(aside(Sphere.DEFAULT), 10);
        Plane plane = (Plane) focused.surfaceInFocus();
        assertThat(plane.point().distance(1, 8, 11)).isLessThan(1e-14);
        assertThat(plane.normal().distance(0, 0.6, 0.8)).isLessThan(1e-15);
        assertThat(FocusDistance.of(focused)).isCloseTo(10, within(1e-14));
        assertThat(focused.focusDistance()).isEqualTo(10);
        Plane behind = (Plane) ((ThinLensCamera) FocusDistance.with(aside(Sphere.DEFAULT), -10)).surfaceInFocus();
        assertThat(behind.point().distance(plane.point())).isCloseTo(20, within(1e-14));
        assertThat(Descriptions.with(focused, "focusDistance", 0.0))
                .as("nothing else changes")
                .isEqualTo(aside(ThinLensCamera.DEFAULT.focus()));
        for (double nowhere : new double[] {0, Double.NaN, Double.POSITIVE_INFINITY}) {
            assertThatThrownBy(() -> FocusDistance.with(focused, nowhere))
                    .isInstanceOf(InvalidPropertyException.class)
                    .hasMessageStartingWith("focusDistance must be a finite number, not 0");
        }
    }
}
