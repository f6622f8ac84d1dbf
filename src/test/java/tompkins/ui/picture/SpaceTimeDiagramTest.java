package tompkins.ui.picture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.geom.Point2D;
import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import tompkins.camera.Camera;
import tompkins.sceneobject.Plane;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Mirror;
import tompkins.trace.RenderPlan;
import tompkins.ui.Studios;

/** The expected places are closed formulas of the Lorentz transformation with beta = 0.8, gamma = 5/3. */
class SpaceTimeDiagramTest {

    private static final Velocity FORWARDS = Velocity.of(0, 0, 0.8);

    private static SpaceTimeDiagram diagram(Studio studio) {
        return PixelProbe.read(RenderPlan.of(studio), new Point2D.Double(32, 24))
                .diagram();
    }

    private static Plane wall(double z) {
        return new Plane("wall", new Vector3d(0, 0, z), new Vector3d(0, 0, 1), ColouredSurface.DEFAULT);
    }

    private static void assertPlaces(List<Point2D> places, double... expected) {
        assertThat(places).hasSize(expected.length / 2);
        for (int i = 0; i < places.size(); i++) {
            assertPlace(places.get(i), expected[2 * i], expected[2 * i + 1]);
        }
    }

    private static void assertPlace(Point2D place, double x, double y) {
        assertThat(place.getX()).isEqualTo(x, within(1e-12));
        assertThat(place.getY()).isEqualTo(y, within(1e-12));
    }

    @Test
    void lightAlongTheVelocityRunsAtFortyFiveDegreesBetweenTheAxesOfTheCamera() {
        SpaceTimeDiagram diagram = diagram(Studios.sphere().withVelocity(FORWARDS));
        assertPlaces(diagram.path(), 0, 0, 9, -9);
        assertPlace(diagram.cameraTime(), 4 / 3.0, 5 / 3.0);
        assertPlace(diagram.cameraSpace(), 5 / 3.0, 4 / 3.0);
        assertThat(diagram.onwards()).isNull();
        assertThat(diagram.reach()).isEqualTo(9, within(1e-12));
    }

    @Test
    void timeIsTheSameForAllInAGalileanWorld() {
        SpaceTimeDiagram diagram =
                diagram(Studios.sphere().withVelocity(FORWARDS).withTransformation(TransformationLaw.GALILEAN));
        assertPlace(diagram.cameraTime(), 0.8, 1);
        assertPlace(diagram.cameraSpace(), 1, 0);
    }

    /** Seen straight ahead by a camera that moves sideways, light follows its way, as far as x goes. */
    @Test
    void lightAcrossTheVelocityKeepsBesideTheCamera() {
        Studio studio = Studios.sphere().withVelocity(Velocity.of(0.8, 0, 0)).withScene(List.of(wall(6)));
        assertPlaces(diagram(studio).path(), 0, 0, -8, -10);
        Camera later = studio.camera().withShutter(studio.camera().shutter().openedAt(12));
        assertPlaces(diagram(studio.withCamera(later)).path(), 0, 0, -8, -10);
    }

    /** The event z = 2, t = -2 of the camera frame. */
    @Test
    void whatMovesWithTheCameraIsShownInTheSceneFrame() {
        Studio studio = Studios.sphere().withVelocity(FORWARDS).withCameraFrame(List.of(wall(2)));
        assertPlaces(diagram(studio).path(), 0, 0, 2 / 3.0, -2 / 3.0);
    }

    @Test
    void aRayThatMeetsNothingGoesOn() {
        SpaceTimeDiagram diagram = diagram(Studios.sphere().withScene(List.of()));
        assertPlaces(diagram.path(), 0, 0);
        assertPlace(diagram.onwards(), 1, -1);
        assertThat(diagram.reach()).isZero();
    }

    /** Back from a mirror that faces the camera. */
    @Test
    void aRayThatAMirrorSendsToTheBackgroundGoesOnBackwards() {
        Plane mirror = new Plane("mirror", new Vector3d(0, 0, 6), new Vector3d(0, 0, 1), new Mirror(0.9));
        SpaceTimeDiagram diagram = diagram(Studios.sphere().withScene(List.of(mirror)));
        assertPlaces(diagram.path(), 0, 0, 6, -6);
        assertPlace(diagram.onwards(), -1, -1);
    }
}
