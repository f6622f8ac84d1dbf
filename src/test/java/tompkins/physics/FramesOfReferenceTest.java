package tompkins.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import tompkins.camera.Camera;
import tompkins.camera.ThinLensCamera;
import tompkins.image.LinearImage;
import tompkins.property.Descriptions;
import tompkins.sceneobject.CylinderLattice;
import tompkins.sceneobject.Plane;
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
