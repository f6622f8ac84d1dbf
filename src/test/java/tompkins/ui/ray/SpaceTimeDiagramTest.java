package tompkins.ui.ray;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.io.IOException;
import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import tompkins.camera.Camera;
import tompkins.io.BundledScenes;
import tompkins.measure.Sighting;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.Rotating;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Mirror;
import tompkins.trace.Frame;
import tompkins.trace.RenderPlan;

/** The expected places are closed formulas of the Lorentz transformation with beta = 0.8, gamma = 5/3. */
class SpaceTimeDiagramTest {

    private static final Velocity FORWARDS = Velocity.of(0, 0, 0.8);

    private static SpaceTimeDiagram diagram(Studio studio) {
        return diagram(studio, Frame.SCENE);
    }

    private static SpaceTimeDiagram diagram(Studio studio, Frame frame) {
        return SpaceTimeDiagram.of(Sighting.of(RenderPlan.of(studio), 32, 24).life(), studio, frame);
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
    void lightHalvesTheAngleOfTheCameraAxes() {
        SpaceTimeDiagram diagram = diagram(Studios.sphere().withVelocity(FORWARDS));
        assertPlaces(diagram.path(), 0, 0, 9, -9);
        assertPlace(diagram.otherTime(), 4 / 3.0, 5 / 3.0);
        assertPlace(diagram.otherSpace(), 5 / 3.0, 4 / 3.0);
        assertThat(diagram.onwards()).isNull();
        assertThat(diagram.area().getMaxX()).as("with some room").isEqualTo(1.12 * 9, within(1e-12));
    }

    @Test
    void timeIsTheSameForAllInAGalileanWorld() {
        SpaceTimeDiagram diagram =
                diagram(Studios.sphere().withVelocity(FORWARDS).withTransformation(TransformationLaw.GALILEAN));
        assertPlace(diagram.otherTime(), 0.8, 1);
        assertPlace(diagram.otherSpace(), 1, 0);
    }

    /** Its light has the speed 1 in the camera frame: 1.8 and -0.2 in the scene, if it runs along the velocity. */
    @Test
    void lightOfAGalileanWorldRunsWithTheCamera() {
        Studio galilean = Studios.sphere()
                .withScene(List.of())
                .withVelocity(FORWARDS)
                .withTransformation(TransformationLaw.GALILEAN);
        SpaceTimeDiagram scene = diagram(galilean);
        assertPlaces(scene.light(), 1.8, 1, -0.2, 1);
        // light that comes from ahead runs against the velocity: seen backwards, 1 forwards in a time of 5
        assertPlace(scene.onwards(), 1, -5);
        SpaceTimeDiagram camera = diagram(galilean, Frame.CAMERA);
        assertPlaces(camera.light(), 1, 1, -1, 1);
        assertPlace(camera.onwards(), 5, -5);
        Studio lorentz = Studios.sphere().withVelocity(FORWARDS);
        assertPlaces(diagram(lorentz).light(), 3, 3, -1 / 3.0, 1 / 3.0);
        assertPlaces(diagram(lorentz, Frame.CAMERA).light(), 1, 1, -1, 1);
    }

    /**
     * 9 = distance in the scene, which is sqrt((1 - beta) / (1 + beta)) = 1/3 of that in the camera frame, backwards.
     */
    @Test
    void theCameraSeesTheSameEventsFromItsOwnAxes() {
        SpaceTimeDiagram diagram = diagram(Studios.sphere().withVelocity(FORWARDS), Frame.CAMERA);
        assertPlaces(diagram.path(), 0, 0, 27, -27);
        assertPlace(diagram.otherTime(), -4 / 3.0, 5 / 3.0);
        assertPlace(diagram.otherSpace(), 5 / 3.0, -4 / 3.0);
        Studio galilean = Studios.sphere().withVelocity(FORWARDS).withTransformation(TransformationLaw.GALILEAN);
        assertPlace(diagram(galilean, Frame.CAMERA).otherTime(), -0.8, 1);
        assertPlace(diagram(galilean, Frame.CAMERA).otherSpace(), 1, 0);
    }

    /** What is straight ahead of a camera that moves sideways has its place across x. */
    @Test
    void lightAcrossTheVelocityComesToTheCameraAcrossIt() {
        Studio studio = Studios.sphere().withVelocity(Velocity.of(0.8, 0, 0)).withScene(List.of(wall(6)));
        assertPlaces(diagram(studio, Frame.CAMERA).path(), 0, 0, 0, -6);
        Studio held = Studios.sphere().withVelocity(FORWARDS).withCameraFrame(List.of(wall(2)));
        assertPlaces(diagram(held, Frame.CAMERA).path(), 0, 0, 2, -2);
    }

    /** A step to the background is 3 times as long in the frame that moves towards it. */
    @Test
    void aRayThatMeetsNothingGoesOnInTheCameraFrameToo() {
        Studio empty = Studios.sphere().withScene(List.of()).withVelocity(FORWARDS);
        assertPlace(diagram(empty, Frame.CAMERA).onwards(), 3, -3);
        assertPlace(diagram(empty, Frame.SCENE).onwards(), 1, -1);
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

    private static void assertSlope(Point2D direction, double speed) {
        assertThat(direction.getX() / direction.getY()).isEqualTo(speed, within(1e-12));
        assertThat(direction.getY()).isPositive();
    }

    /** Speeds along one line add to (u + v)/(1 + u v), or to u + v for Newton. */
    @Test
    void theWorldLineOfWhatMovesIsSlanted() {
        Moving wall = new Moving("moving", Velocity.of(0, 0, 0.5), new Vector3d(0, 0, 6), 0, List.of(wall(0)));
        Studio atRest = Studios.sphere().withScene(List.of(wall));
        assertSlope(diagram(atRest).object(), 0.5);
        // z = 6 + 0.5 t meets z = -t
        assertPlaces(diagram(atRest).path(), 0, 0, 4, -4);
        Studio moving = atRest.withVelocity(FORWARDS);
        assertSlope(diagram(moving).object(), 0.5);
        assertSlope(diagram(moving, Frame.CAMERA).object(), (0.5 - 0.8) / (1 - 0.5 * 0.8));
        Moving inner = new Moving("inner", Velocity.of(0, 0, 0.5), new Vector3d(), 0, List.of(wall(1)));
        Moving outer = new Moving("outer", Velocity.of(0, 0, 0.5), new Vector3d(0, 0, 6), 0, List.of(inner));
        assertSlope(diagram(atRest.withScene(List.of(outer))).object(), 0.8);
        Studio newton = atRest.withScene(List.of(outer)).withTransformation(TransformationLaw.GALILEAN);
        assertSlope(diagram(newton).object(), 1);
    }

    @Test
    void theWorldLineOfWhatRestsInAFrameIsItsTime() {
        Studio scene = Studios.sphere().withVelocity(FORWARDS);
        assertSlope(diagram(scene).object(), 0);
        assertSlope(diagram(scene, Frame.CAMERA).object(), -0.8);
        Studio held = scene.withCameraFrame(List.of(wall(2)));
        assertSlope(diagram(held).object(), 0.8);
        assertSlope(diagram(held, Frame.CAMERA).object(), 0);
        assertThat(diagram(scene.withScene(List.of())).object()).isNull();
    }

    /** Of a camera at rest nobody wants to see how things move across what is drawn. */
    @Test
    void theObjectSaysWhatIsAlongXIfTheCameraRests() {
        Moving wall = new Moving("moving", Velocity.of(-0.6, 0, 0), new Vector3d(0, 0, 6), 0, List.of(wall(0)));
        SpaceTimeDiagram diagram = diagram(Studios.sphere().withScene(List.of(wall)));
        assertSlope(diagram.object(), 0.6);
        assertPlaces(diagram.path(), 0, 0, 0, -6);
    }

    /** The front of a ball, (2, 0, -1) from an axis along y, runs with 0.25 times (-1, 0, -2) when its light leaves. */
    @Test
    void theWorldLineOfWhatTurnsIsThatOfItsPoint() {
        Rotating turning = new Rotating(
                "turning",
                new Vector3d(-2, 0, 10),
                new Vector3d(0, 1, 0),
                0.25,
                Math.toDegrees(0.25 * 9),
                List.of(new Sphere("ball", new Vector3d(0, 0, 10), 1, ColouredSurface.DEFAULT)));
        Studio scene = Studios.sphere().withScene(List.of(turning));
        assertSlope(diagram(scene).object(), 0.25 * Math.sqrt(5));
    }

    @Test
    void aRayThatMeetsNothingGoesOn() {
        SpaceTimeDiagram diagram = diagram(Studios.sphere().withScene(List.of()));
        assertPlaces(diagram.path(), 0, 0);
        assertPlace(diagram.onwards(), 1, -1);
        assertThat(diagram.area().getWidth()).isEqualTo(2 * 1.12, within(1e-12));
    }

    /** Back from a mirror that faces the camera. */
    @Test
    void aRayThatAMirrorSendsToTheBackgroundGoesOnBackwards() {
        Plane mirror = new Plane("mirror", new Vector3d(0, 0, 6), new Vector3d(0, 0, 1), new Mirror(0.9));
        SpaceTimeDiagram diagram = diagram(Studios.sphere().withScene(List.of(mirror)));
        assertPlaces(diagram.path(), 0, 0, 6, -6);
        assertPlace(diagram.onwards(), -1, -1);
    }

    /**
     * Home is 4 away at the turn, at time 5: what is simultaneous there is 5 - 0.8 * 4 before and 5 + 0.8 * 4 after.
     */
    @Test
    void nowAtHomeJumpsWhenATwinTurns() throws IOException {
        SpaceTimeDiagram twins = SpaceTimeDiagram.ofRide(BundledScenes.studio("lesson-18-twins.json"));

        Point2D end = twins.path().get(twins.path().size() - 1);
        assertThat(end.distance(0, 10)).isLessThan(1e-4);
        assertThat(twins.lightThrough())
                .singleElement()
                .satisfies(turn -> assertThat(turn.distance(4, 5)).isLessThan(1e-4));
        assertThat(twins.simultaneous()).hasSize(2);
        assertThat(twins.simultaneous().get(0).getP2().distance(0, 1.8)).isLessThan(1e-4);
        assertThat(twins.simultaneous().get(1).getP2().distance(0, 8.2)).isLessThan(1e-4);
        // light that is seen at the turn left home at 1; the turn is seen there at 9
        assertThat(twins.notes())
                .extracting(SpaceTimeDiagram.Note::text)
                .containsExactlyInAnyOrder(
                        "t\u2032 = 3", "t = 1.8", "t = 1", "t = 9", "t = 8.2", "t\u2032 = 6", "t = 10");
        assertThat(twins.area().contains(new Line2D.Double(0, 0, 4, 10).getBounds2D()))
                .isTrue();
    }
}
