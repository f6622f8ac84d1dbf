package tompkins.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.property.Descriptions;
import tompkins.property.InvalidPropertyException;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.ray.RayPacket;
import tompkins.sceneobject.Disc;
import tompkins.sceneobject.Group;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.shutter.ArbitraryPlaneShutter;
import tompkins.shutter.FocusSurfaceShutter;
import tompkins.shutter.LensRay;
import tompkins.shutter.Shutter;
import tompkins.spacetime.IdentityTransformation;
import tompkins.surface.ColouredSurface;

/** Which ray belongs to which point of the picture, for cameras that stand and look anywhere. */
class CameraRaysTest {

    private static final double SMALL = 1e-14;
    private static final Vector3dc POSITION = new Vector3d(1, -2, 3);
    private static final IdentityTransformation REST = new IdentityTransformation();

    /** Looks along x + z with its top tilted; the axes of the camera are then known by hand. */
    private static ThinLensCamera thinLens(double vertical, double aperture, Shutter shutter) {
        return Cameras.lens(
                POSITION,
                new Vector3d(3, 0, 3),
                new Vector3d(0.5, 2, 0.1),
                90,
                vertical,
                aperture,
                new Plane("focus", new Vector3d(11, -2, 13), new Vector3d(1, 0, 1), ColouredSurface.DEFAULT),
                0,
                shutter);
    }

    private static final Vector3dc FORWARD = new Vector3d(1, 0, 1).normalize();
    private static final Vector3dc RIGHT =
            new Vector3d(0.5, 2, 0.1).cross(1, 0, 1, new Vector3d()).normalize();
    private static final Vector3dc UP = FORWARD.cross(RIGHT, new Vector3d());

    private static Vector3d direction(double right, double up) {
        return new Vector3d(FORWARD)
                .add(new Vector3d(RIGHT).mul(right))
                .add(new Vector3d(UP).mul(up))
                .normalize();
    }

    @ParameterizedTest
    @CsvSource({
        // column, row, slope to the right, slope up: 90 degrees wide, square pixels
        "40, 15, 0, 0",
        "0, 15, -1, 0",
        "80, 15, 1, 0",
        "40, 0, 0, 0.375",
        "40, 30, 0, -0.375",
        "60, 5, 0.5, 0.25"
    })
    void picturePointsAreSlopes(double x, double y, double right, double up) {
        CameraRays rays = thinLens(0, 0, AperturePlaneShutter.DEFAULT).rays(80, 30, REST);
        assertThat(rays.chiefDirection(x, y).distance(direction(right, up))).isLessThan(SMALL);
        Ray ray = rays.ray(x, y, 0.3, -0.2, new RayCounts());
        assertThat(new Vector3d(ray.dx, ray.dy, ray.dz).distance(direction(right, up)))
                .isLessThan(SMALL);
        assertThat(new Vector3d(ray.x, ray.y, ray.z)).isEqualTo(POSITION);
        // the pixel's angle shrinks by the squared cosine towards the edge
        double cosine = direction(right, up).dot(FORWARD);
        assertThat(ray.spread).isCloseTo(2.0 / 80 * cosine * cosine, within(SMALL));
    }

    @Test
    void secondAngleMakesOblongPixels() {
        CameraRays rays = thinLens(2 * Math.toDegrees(Math.atan(0.2)), 0, AperturePlaneShutter.DEFAULT)
                .rays(80, 30, REST);
        assertThat(rays.chiefDirection(40, 0).distance(direction(0, 0.2))).isLessThan(SMALL);
        assertThat(rays.ray(40, 15, 0, 0, new RayCounts()).spread)
                .isCloseTo(Math.sqrt(2.0 / 80 * 0.4 / 30), within(SMALL));
    }

    @Test
    void lensPointsLieOnTheLens() {
        CameraRays rays = thinLens(0, 0.25, new AperturePlaneShutter(4)).rays(80, 30, REST);
        Ray ray = rays.ray(60, 5, 0.6, -0.4, new RayCounts());
        Vector3d expected =
                new Vector3d(POSITION).add(new Vector3d(RIGHT).mul(0.15)).add(new Vector3d(UP).mul(-0.1));
        assertThat(expected.distance(ray.x, ray.y, ray.z)).isLessThan(SMALL);
        assertThat(ray.time).isEqualTo(4);
        // the plane in focus lies 10 sqrt(2) ahead along the axis
        Vector3d image = direction(0.5, 0.25);
        image.mul(10 * Math.sqrt(2) / image.dot(FORWARD)).add(POSITION);
        Vector3d towards = image.sub(expected).normalize();
        assertThat(towards.distance(ray.dx, ray.dy, ray.dz)).isLessThan(SMALL);
    }

    /** Of several surfaces in focus the nearest in front counts, else the nearest behind. */
    @Test
    void nearestSurfaceInFrontIsInFocus() {
        Shutter shutter = new FocusSurfaceShutter(0);
        assertThat(timeInFocus(shutter, 5, 3, 8)).isCloseTo(3, within(SMALL));
        assertThat(timeInFocus(shutter, 8, 3, 5)).isCloseTo(3, within(SMALL));
        assertThat(timeInFocus(shutter, -2, 7, -4)).isCloseTo(7, within(SMALL));
        assertThat(timeInFocus(shutter, 7, -2)).isCloseTo(7, within(SMALL));
        assertThat(timeInFocus(shutter, -4, -2, -3)).isCloseTo(-2, within(SMALL));
        assertThat(timeInFocus(shutter, -2, -4)).isCloseTo(-2, within(SMALL));
    }

    private static double timeInFocus(Shutter shutter, double... distances) {
        List<SceneObject> discs = Arrays.stream(distances)
                .mapToObj(z -> (SceneObject)
                        new Disc("", new Vector3d(0, 0, z), new Vector3d(0, 0, 1), 1, ColouredSurface.DEFAULT))
                .toList();
        Camera camera = Descriptions.with(ThinLensCamera.DEFAULT, "focus", new Group("", discs))
                .withShutter(shutter);
        return camera.rays(2, 2, REST).ray(1, 1, 0, 0, new RayCounts()).time;
    }

    @Test
    void camerasKnowTheirPoints() {
        ThinLensCamera camera = thinLens(0, 0.1, AperturePlaneShutter.DEFAULT);
        assertThat(camera.hasWideAperture()).isTrue();
        assertThat(thinLens(0, 0, AperturePlaneShutter.DEFAULT).hasWideAperture())
                .isFalse();
        assertThat(PanoramicCamera.DEFAULT.hasWideAperture()).isFalse();
        Map<Camera, Double> inverseDistances =
                Map.of(camera, 0.6 / 20, panoramic(AperturePlaneShutter.DEFAULT), 1.0 / 4);
        inverseDistances.forEach((each, inverseDistance) -> {
            LensRay ray = each.withShutter(new FocusSurfaceShutter(0))
                    .rays(2, 2, REST)
                    .chiefRay(new Vector3d(0, 0.8, 0.6));
            assertThat(ray.centre()).isEqualTo(POSITION).isEqualTo(ray.pupilPoint());
            assertThat(ray.chiefDirection().distance(0, 0.8, 0.6)).isLessThan(SMALL);
            assertThat(ray.inverseFocusDistance()).isCloseTo(inverseDistance, within(SMALL));
            assertThat(each.withShutter(new FocusSurfaceShutter(3)).shutter()).isEqualTo(new FocusSurfaceShutter(3));
        });
    }

    private static PanoramicCamera panoramic(Shutter shutter) {
        return Cameras.panorama(POSITION, new Vector3d(3, 0, 3), new Vector3d(-1, 2, 1), 180, 90, 4, 0, shutter);
    }

    @ParameterizedTest
    @CsvSource({
        // column, row, longitude, latitude in degrees
        "90, 45, 0, 0",
        "180, 45, 90, 0",
        "0, 45, -90, 0",
        "90, 0, 0, 45",
        "90, 90, 0, -45",
        "120, 15, 30, 30"
    })
    void columnsAreLongitudesAndRowsLatitudes(double x, double y, double longitude, double latitude) {
        // top perpendicular to the view
        Vector3d up = new Vector3d(-1, 2, 1);
        up.sub(new Vector3d(FORWARD).mul(up.dot(FORWARD))).normalize();
        Vector3d right = up.cross(FORWARD, new Vector3d());
        double level = Math.cos(Math.toRadians(latitude));
        Vector3d expected = new Vector3d(FORWARD)
                .mul(level * Math.cos(Math.toRadians(longitude)))
                .add(right.mul(level * Math.sin(Math.toRadians(longitude))))
                .add(up.mul(Math.sin(Math.toRadians(latitude))));
        CameraRays rays = panoramic(new FocusSurfaceShutter(1)).rays(180, 90, REST);
        assertThat(rays.chiefDirection(x, y).distance(expected)).isLessThan(SMALL);
        Ray ray = rays.ray(x, y, 1, 1, new RayCounts());
        assertThat(expected.distance(ray.dx, ray.dy, ray.dz)).isLessThan(SMALL);
        assertThat(new Vector3d(ray.x, ray.y, ray.z)).isEqualTo(POSITION);
        assertThat(ray.time).isCloseTo(5, within(SMALL));
        assertThat(ray.spread).isCloseTo(Math.toRadians(1), within(SMALL));
    }

    @Test
    void panoramicRaysThatMissTheShutterAreCounted() {
        RayCounts counts = new RayCounts();
        Shutter shutter = new ArbitraryPlaneShutter(0, new Vector3d(0, 0, 0), new Vector3d(0, 1, 0));
        PanoramicCamera camera =
                Cameras.panorama(new Vector3d(), new Vector3d(0, 0, 1), new Vector3d(0, 1, 0), 360, 180, 1, 0, shutter);
        assertThat(camera.rays(4, 4, REST).ray(2, 2, 0, 0, counts)).isNull();
        assertThat(counts.withoutShutter).isEqualTo(1);
    }

    /** Rays across the normal of a plane never meet it. */
    @ParameterizedTest
    @MethodSource("camerasThatLookAlongZ")
    void raysWithoutShutterLeaveNoGapsInThePacket(Camera camera) {
        CameraRays cameraRays = camera.withShutter(
                        new ArbitraryPlaneShutter(0, new Vector3d(0, -1, 0), new Vector3d(0, 1, 0)))
                .rays(4, 4, REST);
        SamplePositions places = new SamplePositions(4);
        places.add(1, 2, 0, 0, 0.5);
        places.add(1, 1, 0, 0, 0.5);
        places.add(2, 2, 0, 0, 0.5);
        places.add(3, 3, 0, 0, 0.5);
        RayPacket rays = new RayPacket(4);
        RayCounts counts = new RayCounts();

        cameraRays.make(places, rays, counts);

        assertThat(counts.withoutShutter).isEqualTo(2);
        assertThat(rays.count()).isEqualTo(2);
        for (int i = 0; i < 2; i++) {
            Ray ray = rays.ray(i);
            assertThat(rays.sample(i)).isEqualTo(2 * i + 1);
            assertThat(cameraRays.chiefDirection(2 * i + 1, 2 * i + 1).distance(ray.dx, ray.dy, ray.dz))
                    .isLessThan(SMALL);
            // from y = 0 to the plane y = -1, against the light
            assertThat(ray.time).isCloseTo(-1 / ray.dy, within(SMALL * Math.abs(ray.time)));
        }
    }

    static List<Camera> camerasThatLookAlongZ() {
        return List.of(
                ThinLensCamera.DEFAULT,
                Descriptions.with(
                        Descriptions.with(PanoramicCamera.DEFAULT, "horizontalAngleDegrees", 120.0),
                        "verticalAngleDegrees",
                        80.0));
    }

    /** Meridians come nearer to each other like the cosine of the latitude. */
    @Test
    void panoramicPixelsGetNarrowerTowardsThePoles() {
        CameraRays rays = panoramic(AperturePlaneShutter.DEFAULT).rays(45, 90, REST);
        assertThat(rays.ray(10, 45, 0, 0, new RayCounts()).spread).isCloseTo(Math.toRadians(4), within(SMALL));
        assertThat(rays.ray(10, 15, 0, 0, new RayCounts()).spread)
                .isCloseTo(Math.toRadians(4) * Math.sqrt(0.75), within(SMALL));
    }

    @Test
    void topAlongTheViewIsRefused() {
        assertThatThrownBy(() -> Descriptions.with(PanoramicCamera.DEFAULT, "topDirection", new Vector3d(0, 0, -2)))
                .isInstanceOf(InvalidPropertyException.class)
                .hasMessageContaining("topDirection");
    }
}
