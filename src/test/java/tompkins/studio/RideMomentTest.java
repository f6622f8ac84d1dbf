package tompkins.studio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.animation.RideFilm;
import tompkins.camera.Aim;
import tompkins.camera.Camera;
import tompkins.camera.CameraMotion;
import tompkins.camera.FieldOfView;
import tompkins.camera.PanoramicCamera;
import tompkins.camera.ThinLensCamera;
import tompkins.property.Descriptions;
import tompkins.ray.Ray;
import tompkins.sceneobject.Placed;
import tompkins.sceneobject.Sphere;
import tompkins.shutter.Shutter;
import tompkins.spacetime.Event;
import tompkins.spacetime.LorentzTransformation;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.trace.RenderPlan;

class RideMomentTest {

    private static final Vector3dc FORWARDS = new Vector3d(0, 0, 1);

    static Stream<Studio> studios() {
        Studio lattice = Studios.lattice();
        Camera aside = Descriptions.with(ThinLensCamera.DEFAULT, "position", new Vector3d(0.5, -2, 3));
        return Stream.of(
                Studios.sphere(),
                lattice,
                lattice.withCamera(Descriptions.with(PanoramicCamera.DEFAULT, "position", new Vector3d(1, 2, 3))),
                lattice.withCamera(CameraMotion.turned(aside, new Vector3d(1, 0.1, 0.2), new Vector3d(0, 1, 0))),
                lattice.withCamera(aside).withTransformation(TransformationLaw.GALILEAN),
                lattice.withCamera(aside).withTransformation(TransformationLaw.NONE));
    }

    static Stream<Studio> shutters() {
        return Descriptions.members(Shutter.class).stream()
                .map(type -> (Shutter) Descriptions.standard(type))
                .map(shutter -> Studios.lattice()
                        .withCamera(CameraMotion.turned(
                                        ThinLensCamera.DEFAULT, new Vector3d(0.4, 0.1, 1), new Vector3d(0, 1, 0))
                                .withShutter(shutter.openedAt(0.7))));
    }

    /** The photographs are taken at the events of the world line, whatever lens, law and shutter. */
    @ParameterizedTest
    @MethodSource({"studios", "shutters"})
    void photographsAreTakenOnTheWorldLine(Studio studio) {
        Event begin = RenderPlan.of(studio).middleHistory().sceneStart();
        RideMoment moment = RideMoment.start(studio);
        assertThat(distance(moment.rider().event(), begin)).isLessThan(1e-9);
        for (int i = 0; i < 20; i++) {
            moment = moment.after(new Vector3d(Math.sin(i), 0.3, 1), 0.1);
            Event lens = RenderPlan.of(moment.studio()).middleHistory().sceneStart();
            assertThat(distance(lens, moment.rider().event())).isLessThan(1e-8);
            assertThat(moment.studio()
                            .velocity()
                            .proper()
                            .distance(moment.rider().proper()))
                    .isLessThan(1e-12 * (1 + moment.rider().gamma()));
        }
        assertThat(moment.properTime()).isCloseTo(2, within(1e-12));
        assertThat(moment.sceneTime()).isGreaterThan(2);
    }

    private static double distance(Event one, Event other) {
        return one.position().distance(other.position()) + Math.abs(one.time() - other.time());
    }

    /** From rest along z: z = (cosh(a s) - 1)/a, and the accelerometer shows a in the direction of the view. */
    @Test
    void thrustIsAlongTheView() {
        Studio studio = Studios.sphere();
        Studio end = RideMoment.start(studio).after(FORWARDS, 1.5).studio();
        Event lens = RenderPlan.of(end).middleHistory().sceneStart();
        assertThat(lens.z()).isCloseTo(Math.cosh(1.5) - 1, within(1e-12));
        assertThat(lens.time()).isCloseTo(Math.sinh(1.5), within(1e-12));
        assertThat(end.velocity().speed()).isCloseTo(Math.tanh(1.5), within(1e-12));
        Studio aside =
                RideMoment.start(studio).after(new Vector3d(1, 0, 0), 1.5).studio();
        assertThat(aside.velocity().direction().distance(studio.camera().rightDirection()))
                .isLessThan(1e-15);
    }

    /**
     * From rest along z, the camera is at z = (cosh(a s) - 1)/a at the time sinh(a s)/a of the scene, and so is one at
     * rest there; in the frame of the first, z would be (1 - cosh(a s))/a, behind the beginning.
     */
    @Test
    void aCameraAtRestIsWhereTheRideIs() {
        Studio studio = Studios.sphere();
        Studio rest = RideMoment.start(studio).after(FORWARDS, 1.5).atRest();
        assertThat(rest.velocity().isRest()).isTrue();
        assertThat(rest.camera().position().z()).isCloseTo(Math.cosh(1.5) - 1, within(1e-12));
        assertThat(rest.camera().shutter().openingTime()).isCloseTo(Math.sinh(1.5), within(1e-12));
        assertThat(rest.camera().viewDirection()).isEqualTo(studio.camera().viewDirection());
    }

    /**
     * Sideways thrust at high speed: the picture changes no more than it must. A star that is seen in the middle is
     * aberrated by the small boost on board alone; without the turn of Wigner it would jump aside.
     */
    @Test
    void pictureDoesNotJumpUnderSidewaysThrust() {
        Studio fast = Studios.lattice().withVelocity(Velocity.of(0, 0, 0.99));
        Vector3d star = new LorentzBack(fast).scene(fast.camera().viewDirection());
        double rapidity = 1e-3;
        Studio after = RideMoment.start(fast)
                .after(new Vector3d(1e3, 0, 0), rapidity / 1e3)
                .studio();
        Vector3d now = new LorentzBack(after).camera(star);
        // across the boost on board a star moves towards it by the angle of that boost
        assertThat(now.dot(after.camera().rightDirection())).isCloseTo(Math.tanh(rapidity), within(1e-12));
        assertThat(now.dot(after.camera().upDirection())).isCloseTo(0, within(1e-12));
    }

    /** Directions between the frames of a studio. */
    private record LorentzBack(Studio studio) {

        Vector3d scene(Vector3dc inCamera) {
            return turned(new LorentzTransformation(studio.velocity()), inCamera);
        }

        Vector3d camera(Vector3dc inScene) {
            return turned(new LorentzTransformation(studio.velocity()).inverse(), inScene);
        }

        private static Vector3d turned(LorentzTransformation change, Vector3dc direction) {
            Ray ray = change.transform(Ray.from(0, 0, 0, direction.x(), direction.y(), direction.z(), 0));
            return new Vector3d(ray.dx, ray.dy, ray.dz);
        }
    }

    /** What moves with the camera is seen where it was, however long the ride. */
    @Test
    void whatIsOnBoardStaysInThePicture() {
        Studio ship = Studios.lattice().withCameraFrame(List.of(Sphere.DEFAULT));
        RideMoment moment = RideMoment.start(ship);
        for (int i = 0; i < 30; i++) {
            moment = moment.after(new Vector3d(0.5, Math.cos(i), 1), 0.2);
        }
        Placed placed = (Placed) moment.studio().cameraFrame().get(0);
        assertThat(placed.object()).isEqualTo(Sphere.DEFAULT);
        Vector3d axis = new Vector3d(placed.rotationAxis()).normalize();
        Vector3d centre = new Vector3d(Sphere.DEFAULT.centre())
                .rotateAxis(Math.toRadians(placed.rotationDegrees()), axis.x, axis.y, axis.z)
                .add(placed.translation());
        Camera camera = moment.studio().camera();
        Vector3d seen = centre.sub(camera.position());
        assertThat(seen.dot(new Vector3d(camera.viewDirection()).normalize()))
                .isCloseTo(Sphere.DEFAULT.centre().z(), within(1e-9));
        assertThat(seen.dot(camera.rightDirection())).isCloseTo(0, within(1e-9));
    }

    @Test
    void brakesInThePicture() {
        Studio aside = Studios.sphere().withVelocity(Velocity.of(-0.6, 0, 0));
        RideMoment moment = RideMoment.start(aside);
        Vector3d brake = moment.brake(2);
        assertThat(brake.distance(new Vector3d(2, 0, 0))).isLessThan(1e-12);
        RideMoment end = moment.after(brake, Math.log(2) / 2);
        assertThat(end.studio().velocity().isRest()).isTrue();
    }

    /** A ride is recorded as few legs, and its film leads through the same moments. */
    /** The numbers of a studio round the event by gamma^2 u of its distance, and the ride does not go on from that. */
    @Test
    void roundingGrowsWithTheSquareOfGammaAndDoesNotAddUp() {
        RideMoment moment = RideMoment.start(Studios.sphere());
        double worst = 0;
        for (int i = 1; i <= 80; i++) {
            moment = moment.after(FORWARDS, 0.1);
            double gamma = Math.cosh(0.1 * i);
            double allowed = gamma * gamma * 0x1p-53 * 2 * gamma;
            Event lens = RenderPlan.of(moment.studio()).middleHistory().sceneStart();
            assertThat(distance(lens, moment.rider().event())).isLessThan(4 * allowed);
            worst = Math.max(worst, distance(lens, moment.rider().event()));
            assertThat(moment.rider().event().time()).isCloseTo(Math.sinh(0.1 * i), within(1e-12 * gamma));
        }
        assertThat(worst).isGreaterThan(1e-9);
    }

    @Test
    void recordedRideIsReplayed() {
        Studio start = Studios.lattice();
        RideRecorder recorder = new RideRecorder(start);
        RideMoment moment = RideMoment.start(start);
        RideMoment middle = null;
        for (int i = 0; i < 60; i++) {
            Vector3d thrust = i < 30 ? new Vector3d(0, 0, -0.8) : new Vector3d(0.5, 0.2, 0);
            if (i == 40) {
                Camera turned = FieldOfView.zoomed(
                        new Aim(0.3, -0.1).turn(moment.studio().camera()), 1.5);
                moment = moment.with(moment.studio().withCamera(turned));
            }
            RideMoment next = moment.after(thrust, 0.06);
            recorder.add(moment.studio(), thrust, 0.06, 0.03, next.studio());
            moment = next;
            middle = i == 49 ? moment : middle;
        }
        Studio recorded = recorder.studio();
        assertThat(recorded.ride()).hasSize(3);
        assertThat(recorder.seconds()).isCloseTo(1.8, within(1e-12));
        assertThat(recorded.withRide(List.of())).isEqualTo(start);

        RideFilm film = new RideFilm(recorded);
        assertThat(film.frames()).isEqualTo(46);
        isSame(film.moment(1.5), middle);
        isSame(film.moment(45), moment);
        assertThat(film.studio(0)).isEqualTo(start);
        assertThat(film.studio(30).ride()).isEmpty();
        isSame(new RideFilm(recorded, 3.6, 10).moment(3.0), middle);
    }

    private static void isSame(RideMoment one, RideMoment other) {
        assertThat(distance(one.rider().event(), other.rider().event())).isLessThan(1e-9);
        assertThat(one.rider().proper().distance(other.rider().proper())).isLessThan(1e-10);
        assertThat(one.properTime()).isCloseTo(other.properTime(), within(1e-12));
        assertThat(one.sceneTime()).isCloseTo(other.sceneTime(), within(1e-10));
        Camera a = one.studio().camera();
        Camera b = other.studio().camera();
        assertThat(a.viewDirection().distance(b.viewDirection())).isLessThan(1e-10);
        assertThat(a.upDirection().distance(b.upDirection())).isLessThan(1e-10);
        assertThat(a.horizontalAngleDegrees()).isCloseTo(b.horizontalAngleDegrees(), within(1e-12));
    }
}
