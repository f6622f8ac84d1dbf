package tompkins.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.IntStream;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.camera.Camera;
import tompkins.camera.ThinLensCamera;
import tompkins.image.LinearImage;
import tompkins.property.Descriptions;
import tompkins.sceneobject.CylinderLattice;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.shutter.DetectorPlaneShutter;
import tompkins.shutter.FixedPointSurfaceShutter;
import tompkins.shutter.FocusSurfaceShutter;
import tompkins.shutter.LensHologramShutter;
import tompkins.shutter.Shutter;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.surface.LorentzWindow;
import tompkins.surface.Tiling;
import tompkins.surface.WindowAxes;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;

/** Who moves, how fast, and what cancels what: the same photograph reached in two ways. */
class FramesOfReferenceTest {

    private static final Vector3dc PAPER = new Vector3d(0.2, -0.1, 0.97);

    /** The same picture, worked out with a camera that stands still and contracted spheres that fly past. */
    @ParameterizedTest
    @CsvSource({"0.2, -0.1, 0.97, 1", "0, 0.9, 0, 0", "-0.3, 0.1, -0.5, 2", "0, 0, 0.99, -1"})
    void movingSceneBeforeARestingCameraGivesTheSamePicture(double bx, double by, double bz, double time) {
        Vector3d beta = new Vector3d(bx, by, bz);
        List<Vector3d> centres = List.of(
                new Vector3d(0, 0, 12), new Vector3d(5, 1, 9), new Vector3d(-4, -3, 20), new Vector3d(2, 8, -5));
        double radius = 4;
        List<SceneObject> spheres = centres.stream()
                .map(centre -> (SceneObject) new Sphere("sphere", centre, radius, Photograph.WHITE))
                .toList();
        Camera camera = Photograph.wholeSky().withShutter(new AperturePlaneShutter(time));
        Photograph photograph = Photograph.of(spheres, camera, Velocity.of(beta), 400, 200);
        double gamma = 1 / Math.sqrt(1 - beta.lengthSquared());
        int lit = 0;
        int different = 0;
        for (int row = 0; row < 200; row++) {
            for (int column = 0; column < 400; column++) {
                Vector3d direction = photograph.cameraDirection(new Vector2d(column + 0.5, row + 0.5));
                boolean expected =
                        centres.stream().anyMatch(centre -> meets(direction, time, centre, radius, beta, gamma));
                lit += expected ? 1 : 0;
                different += expected == photograph.isLit(column, row, 0) ? 0 : 1;
            }
        }
        assertThat(lit).isGreaterThan(50);
        assertThat(different).isZero();
    }

    /**
     * Whether the past of the origin at a time, along a direction, meets a sphere that flies with -beta, contracted.
     */
    private static boolean meets(
            Vector3dc direction, double time, Vector3dc restCentre, double radius, Vector3dc beta, double gamma) {
        Vector3d n = beta.normalize(new Vector3d());
        Vector3d centre =
                new Vector3d(n).mul(restCentre.dot(n) * (1 / gamma - 1)).add(restCentre);
        // place of the light relative to the centre: start + s slope, at time `time - s`
        Vector3d start = new Vector3d(beta).mul(time).sub(centre);
        Vector3d slope = new Vector3d(direction).sub(beta);
        start.add(new Vector3d(n).mul(start.dot(n) * (gamma - 1)));
        slope.add(new Vector3d(n).mul(slope.dot(n) * (gamma - 1)));
        double a = slope.lengthSquared();
        double b = start.dot(slope);
        double c = start.lengthSquared() - radius * radius;
        return b * b >= a * c && (-b + Math.sqrt(b * b - a * c)) > 0;
    }

    private static Studio paperScene() {
        return Studio.DEFAULT
                .withScene(List.of(
                        new Plane("floor", new Vector3d(0, -1, 0), new Vector3d(0, 1, 0), Tiling.DEFAULT),
                        CylinderLattice.DEFAULT))
                .withSettings(Studio.DEFAULT.settings().withSize(160, 120));
    }

    private static double largestDifference(LinearImage one, LinearImage other, double factor) {
        return IntStream.range(0, one.rgb().length)
                .mapToDouble(i -> Math.abs(one.rgb()[i] * factor - other.rgb()[i]))
                .max()
                .orElseThrow();
    }

    @Test
    void windowBeforeTheLensUndoesTheAberration() {
        Velocity velocity = Velocity.of(PAPER);
        Plane window = new Plane(
                "window",
                new Vector3d(0, 0, 0.01),
                new Vector3d(0, 0, 1),
                new LorentzWindow(velocity, WindowAxes.FRAME, 0.96));
        Photograph rest = new Photograph(paperScene().withScene(List.of()));
        Photograph cancelled = new Photograph(
                paperScene().withScene(List.of()).withVelocity(velocity).withCameraFrame(List.of(window)));
        for (int pixel = 0; pixel < 100; pixel++) {
            double x = 1.6 * pixel;
            double y = 119 - 1.1 * pixel;
            SampleHistory ray = cancelled.trace(x, y);
            assertThat(ray.sceneDirection().distance(ray.cameraDirection()))
                    .isLessThan(16 * velocity.gamma() * 0x1p-53);
        }
        assertThat(largestDifference(rest.image(), cancelled.image(), 0.96)).isLessThan(1e-6);
    }

    /** Spread of the places at which the rays of one pixel pass the point in focus, along the velocity. */
    private static double spread(Shutter shutter, int rimPoints, boolean alongVelocity) {
        Vector3d image = new Vector3d(0.3, -0.2, 8);
        Plane focus = new Plane("focus", image, new Vector3d(0, 0, 1), Photograph.WHITE);
        Camera camera = Descriptions.with(
                        Descriptions.with(ThinLensCamera.DEFAULT, "apertureRadius", 0.05), "focus", focus)
                .withShutter(shutter);
        Photograph photograph = Photograph.of(List.of(), camera, Velocity.of(PAPER), 400, 400);
        double pixelsPerSlope = 200 / Math.tan(Math.toRadians(10));
        double x = 200 + image.x / image.z * pixelsPerSlope;
        double y = 200 - image.y / image.z * pixelsPerSlope;
        RenderPlan plan = photograph.plan();
        Vector3d low = new Vector3d(Double.POSITIVE_INFINITY);
        Vector3d high = new Vector3d(Double.NEGATIVE_INFINITY);
        Vector3d n = PAPER.normalize(new Vector3d());
        for (int i = 0; i < rimPoints; i++) {
            double angle = 2 * Math.PI * i / rimPoints;
            SampleHistory ray = SampleHistory.of(plan, x, y, Math.cos(angle), Math.sin(angle));
            double cameraDistance = ray.cameraStart().position().distance(image);
            // distance divided by frequency is the same in both frames
            Vector3d place = new Vector3d(ray.sceneDirection())
                    .mul(cameraDistance / ray.sceneDopplerFactor())
                    .add(ray.sceneStart().position());
            Vector3d seen = alongVelocity ? new Vector3d(place.dot(n), 0, 0) : place;
            low.min(seen);
            high.max(seen);
        }
        return high.sub(low).length();
    }

    @Test
    void detectorPlaneShutterImagesStigmatically() {
        assertThat(spread(new DetectorPlaneShutter(1, 1), 360, false)).isLessThan(1e-12);
        assertThat(spread(new FocusSurfaceShutter(-8), 360, false)).isLessThan(1e-12);
        assertThat(spread(FixedPointSurfaceShutter.DEFAULT, 360, false)).isLessThan(1e-12);
    }

    @Test
    void aperturePlaneShutterBlursAlongTheMotion() {
        assertThat(spread(new AperturePlaneShutter(0), 11, true)).isCloseTo(0.046135, within(1e-6));
        double gammaSpeed = PAPER.length() / Math.sqrt(1 - PAPER.lengthSquared());
        double tilt = 2 * 0.05 * Math.hypot(0.3, 0.2) / Math.hypot(8, Math.hypot(0.3, 0.2));
        assertThat(spread(new AperturePlaneShutter(0), 3600, true)).isCloseTo(gammaSpeed * tilt, within(1e-5));
        assertThat(spread(new LensHologramShutter(1, 1), 360, false)).isGreaterThan(1e-6);
    }

    @Test
    void fixedPointSurfaceLooksUndistorted() {
        Tiling tiles = Tiling.DEFAULT;
        Plane wall = new Plane("wall", new Vector3d(0.3, 0.2, 10), new Vector3d(0, 0, 1), tiles);
        Studio rest = paperScene().withScene(List.of(wall));
        Studio moving = rest.withVelocity(Velocity.of(PAPER))
                .withCamera(rest.camera().withShutter(FixedPointSurfaceShutter.DEFAULT));
        for (int i = 0; i < 50; i++) {
            SampleHistory still = new Photograph(rest).trace(3.2 * i, 2.4 * i);
            SampleHistory flying = new Photograph(moving).trace(3.2 * i, 2.4 * i);
            assertThat(flying.hits()
                            .get(0)
                            .event()
                            .position()
                            .distance(still.hits().get(0).event().position()))
                    .isLessThan(1e-12);
        }
    }
}
