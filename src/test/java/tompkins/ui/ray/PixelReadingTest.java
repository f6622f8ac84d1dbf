package tompkins.ui.ray;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.geom.Point2D;
import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import tompkins.camera.FocusDistance;
import tompkins.camera.PanoramicCamera;
import tompkins.measure.Sighting;
import tompkins.ray.Colour;
import tompkins.sceneobject.Box;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.Event;
import tompkins.spacetime.Velocity;
import tompkins.studio.FrontWindow;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.surface.Clear;
import tompkins.surface.ColouredSurface;
import tompkins.surface.LorentzWindow;
import tompkins.surface.Refractive;
import tompkins.surface.Tiling;
import tompkins.trace.RenderPlan;
import tompkins.ui.picture.Pictures;

/** What is read is held against closed formulas: aberration, the light cone, Doppler's factor. */
class PixelReadingTest {

    private static final double BETA = 0.8;
    private static final double GAMMA = 1 / 0.6;

    private static Sighting read(Studio studio, double x, double y) {
        Point2D place = new Point2D.Double(x, y);
        return PixelReading.of(Pictures.black(studio), place).sighting();
    }

    private static String object(Sighting sighting) {
        return sighting.hit() == null ? null : sighting.hit().object().description();
    }

    @Test
    void besideTheAxisTheRayIsBentByAberration() {
        Studio moving = Studios.sphere().withVelocity(Velocity.of(0, 0, BETA));
        // a pinhole 20 degrees wide, 64 pixels: the pixel edge 0.7 to the right of the middle
        double tangent = 0.7 / 32 * Math.tan(Math.toRadians(10));
        Sighting reading = read(moving, 32.7, 24);
        double cosine = 1 / Math.hypot(1, tangent);
        double sceneCosine = (cosine - BETA) / (1 - BETA * cosine);
        Event event = reading.inScene();
        double distance = event.position().length();
        assertThat(event.z() / distance).isCloseTo(sceneCosine, within(1e-12));
        assertThat(event.position().sub(new Vector3d(0, 0, 10)).length()).isCloseTo(1, within(1e-11));
        assertThat(event.time()).isCloseTo(-distance, within(1e-12));
        assertThat(reading.dopplerFactor()).isCloseTo(1 / (GAMMA * (1 - BETA * cosine)), within(1e-12));
        assertThat(Math.toDegrees(reading.cameraAngle())).isCloseTo(Math.toDegrees(Math.atan(tangent)), within(1e-9));
        // the half angles of aberration: tan(s/2) = sqrt((1 + beta) / (1 - beta)) tan(c/2)
        double sceneHalf = Math.sqrt((1 + BETA) / (1 - BETA)) * Math.tan(Math.atan(tangent) / 2);
        assertThat(Math.toDegrees(reading.sceneAngle()))
                .isCloseTo(Math.toDegrees(2 * Math.atan(sceneHalf)), within(1e-9));
        Event camera = reading.inCamera();
        assertThat(camera.x() / camera.z()).isCloseTo(tangent, within(1e-12));
        assertThat(camera.position().length()).isCloseTo(-camera.time(), within(1e-11));
    }

    /** What was picked is sharp: the focus lies at the depth at which the camera sees the point. */
    @Test
    void pickedDistanceIsThatOfTheEventInTheCameraFrame() {
        Studio moving = Studios.sphere().withVelocity(Velocity.of(0, 0, BETA));
        Point2D middle = new Point2D.Double(32, 24);
        double depth = PixelReading.of(Pictures.black(moving), middle).depth(moving.camera());
        assertThat(depth).isCloseTo(27, within(1e-11));
        Studio focused = moving.withCamera(FocusDistance.with(moving.camera(), depth));
        assertThat(FocusDistance.of(focused.camera())).isCloseTo(27, within(1e-11));
    }

    /** A panorama is in focus on a ball around the camera, also behind it. */
    @Test
    void aPanoramaIsFocusedAtTheDistanceOfWhatWasPicked() {
        Studio studio = Studio.DEFAULT
                .withScene(List.of(new Sphere("side", new Vector3d(-10, 0, -3), 1, ColouredSurface.DEFAULT)))
                .withCamera(PanoramicCamera.DEFAULT)
                .withSettings(Studio.DEFAULT.settings().withSize(360, 180));
        // 106.7 degrees to the left of the middle
        double column = 180 - Math.toDegrees(Math.atan2(10, -3));
        Point2D place = new Point2D.Double(column, 90);
        assertThat(PixelReading.of(Pictures.black(studio), place).depth(studio.camera()))
                .isCloseTo(Math.sqrt(109) - 1, within(1e-9));
    }

    /** Where a cut-out or a silhouette is dark, a ray ends on it; where it is clear, the ray goes on. */
    @Test
    void whatEndsOnTheDarkPartOfAPatternEndsOnItsObject() {
        Studio studio = Studio.DEFAULT.withScene(List.of(new Plane(
                "board",
                new Vector3d(0, 0, 10),
                new Vector3d(0, 0, -1),
                new Tiling(ColouredSurface.DEFAULT, Clear.DEFAULT, 1, 1, false))));
        RenderPlan plan = RenderPlan.of(studio);
        Colour empty = read(Studio.DEFAULT, 320.5, 200.5).life().colour();
        int ended = 0;
        int left = 0;
        for (int column = 0; column < 640; column += 5) {
            Sighting reading = Sighting.of(plan, column + 0.5, 200.5);
            boolean background = reading.life().colour().equals(empty);
            assertThat(object(reading)).isEqualTo(background ? null : "board");
            ended += background ? 0 : 1;
            left += background ? 1 : 0;
        }
        assertThat(ended).isPositive();
        assertThat(left).isPositive();
    }

    /** Of the light that a slab before the lens reflects nothing is told. */
    @Test
    void behindGlassTheMainBranchIsRead() {
        Studio studio = Studios.sphere()
                .withCameraFrame(
                        List.of(new Box("slab", new Vector3d(-5, -5, 2), new Vector3d(5, 5, 3), Refractive.DEFAULT)))
                .withVelocity(Velocity.of(0, 0, 0.6));
        Sighting reading = read(studio, 32, 24);
        assertThat(object(reading)).isEqualTo("sphere");
        assertThat(reading.dopplerFactor()).isCloseTo(2, within(1e-12));
        assertThat(Math.toDegrees(reading.sceneAngle())).isCloseTo(0, within(1e-12));
    }

    @Test
    void theObjectBehindAWindowIsFound() {
        Velocity fast = Velocity.of(0, 0, BETA);
        Studio moving = Studios.sphere().withVelocity(fast);
        Studio corrected = FrontWindow.with(moving, LorentzWindow.DEFAULT.withVelocity(fast));
        Sighting reading = read(corrected, 32, 24);
        assertThat(object(reading)).isEqualTo("sphere");
        assertThat(reading.life().hits()).hasSize(2);
    }

    /** The picture on the screen has twice as many pixels in a row: the second one shows the first half of it. */
    @Test
    void pixelsAreThoseOfThePhotographInItsOwnSize() {
        Studio studio = Studios.sphere().withVelocity(Velocity.of(0.6, 0, 0));
        PixelReading reading = PixelReading.of(Pictures.black(studio, 128, 96), new Point2D.Double(40.25, 30.75));
        assertThat(reading.column()).isEqualTo(40);
        assertThat(reading.row()).isEqualTo(30);
        assertThat(reading.sighting().cameraAngle())
                .isCloseTo(read(studio, 40.25, 30.75).cameraAngle(), within(1e-14))
                .isNotCloseTo(read(studio, 40.5, 30.5).cameraAngle(), within(1e-5));
    }
}
