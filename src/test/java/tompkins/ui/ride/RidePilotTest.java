package tompkins.ui.ride;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.swing.JLabel;
import javax.swing.UIManager;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import tompkins.camera.Aim;
import tompkins.camera.Camera;
import tompkins.camera.CameraMotion;
import tompkins.camera.FieldOfView;
import tompkins.property.Descriptions;
import tompkins.spacetime.Velocity;
import tompkins.studio.LensEvent;
import tompkins.studio.Ride;
import tompkins.studio.RideGoal;
import tompkins.studio.RideLeg;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.ui.Components;
import tompkins.ui.WindowDriver;
import tompkins.ui.model.Settings;
import tompkins.ui.model.StudioModel;
import tompkins.ui.widget.Look;

/** Where rides begin, and what is said where nothing is to be seen; without a display. */
@Timeout(120)
class RidePilotTest {

    private static final Ride FIRST =
            new Ride("first", "Hold W.", new Vector3d(0, 0, -4), Velocity.REST, 2, List.of(), List.of());
    private static final Ride SECOND =
            new Ride("second", "Look down.", new Vector3d(0, 5, 0), Velocity.of(0, 0, 0.6), 1, List.of(), List.of());

    private final Studio photograph = Descriptions.with(
                    Studios.sphere().withVelocity(Velocity.of(0, 0, 0.8)), "rides", List.of(FIRST, SECOND))
            .withRide(List.of(RideLeg.DEFAULT));
    private final StudioModel model = new StudioModel(photograph, null);
    private final List<String> told = new ArrayList<>();
    private final RidePilot pilot = new RidePilot(model, told::add);

    @AfterEach
    void end() {
        onEventThread(() -> pilot.setRiding(false));
    }

    private static void onEventThread(Runnable steps) {
        WindowDriver.onEventThread(steps);
    }

    private Vector3dc lens() {
        return LensEvent.inScene(model.studio()).position();
    }

    @Test
    void aRideOfTheSceneBeginsAtItsStart() {
        onEventThread(() -> {
            pilot.setRiding(true);
            assertThat(model.studio().velocity()).isEqualTo(Velocity.REST);
            assertThat(lens().distance(0, 0, -4)).isLessThan(1e-12);
            assertThat(pilot.task().text()).isEqualTo("Hold W.");
            assertThat(pilot.unitsPerSecond()).isEqualTo(2);
            assertThat(pilot.beginning().ride()).as("nothing is flown yet").isEmpty();
            pilot.setRiding(false);
            model.undo();
            assertThat(model.studio()).isEqualTo(photograph);
        });
    }

    /** The window shows the picture alone then; whoever compares meanwhile goes on comparing. */
    @Test
    void thatARideBeginsIsToldOnce() {
        onEventThread(() -> {
            List<String> begun = new ArrayList<>();
            pilot.setWhenBegun(() -> begun.add("begun"));
            pilot.setRiding(true);
            pilot.setRiding(false);
            pilot.setRiding(true);
            pilot.home();
            assertThat(begun).hasSize(1);
            pilot.begin(SECOND);
            assertThat(begun).hasSize(2);
        });
    }

    /** Who has moved the camera wants to ride from there. */
    @Test
    void fromElsewhereTheRideBeginsThere() {
        onEventThread(() -> {
            model.set(photograph.withCamera(CameraMotion.shifted(photograph.camera(), new Vector3d(1, 0, 0))));
            pilot.setRiding(true);
            assertThat(model.studio().velocity()).isEqualTo(photograph.velocity());
            assertThat(pilot.task().text()).isEmpty();
        });
    }

    @Test
    void whatToTryGoesAndComesWithTheRide() {
        onEventThread(() -> {
            Look.LIGHT.install();
            RidePanel panel =
                    new RidePanel(model, new Settings((Path) null), pilot, () -> {}, studio -> {}, letters -> {});
            panel.setShown(true);
            pilot.begin(SECOND);
            pilot.setRiding(false);
            JLabel task = Components.find(panel.component(), JLabel.class, "ride.task");
            assertThat(task.getText()).isEqualTo("Look down.");
            model.undo();
            assertThat(task.getText()).startsWith("Hold W S");
            model.redo();
            assertThat(task.getText()).isEqualTo("Look down.");
        });
    }

    @Test
    void homeIsTheStartOfTheRide() {
        onEventThread(() -> {
            pilot.begin(SECOND);
            pilot.setThrust(new Vector3d(1, 0, 0));
        });
        WindowDriver.await("some way", () -> lens().x() > 0.01);
        onEventThread(() -> {
            pilot.home();
            assertThat(lens().distance(0, 5, 0)).isLessThan(1e-9);
            assertThat(model.studio().velocity().speed()).isCloseTo(0.6, within(1e-15));
            assertThat(pilot.moment().properTime()).isZero();
        });
    }

    /**
     * Also if it is replayed where it begins. The lens passes 0.24 at the time 0.4 of the scene, which is 1.25 times
     * that on board.
     */
    @Test
    void aMetChallengeIsToldWithWhatWasAsked() {
        onEventThread(() -> {
            pilot.begin(half(1, 0.05));
            pilot.replay();
        });
        WindowDriver.await("the end", () -> !pilot.isRiding());
        Matcher verdict = Pattern.compile("there (\\S+) younger; 0.05 were asked; (\\S+) on board; 1 were allowed: met")
                .matcher(WindowDriver.onEventThread(() -> String.join("\n", told)));
        assertThat(verdict.find()).as("%s", told).isTrue();
        double younger = Double.parseDouble(verdict.group(1));
        double aboard = Double.parseDouble(verdict.group(2));
        assertThat(aboard).isBetween(0.3, 0.75);
        assertThat(younger).isCloseTo(0.25 * aboard, within(0.07));
    }

    /** To fly half a unit along z, at 0.6 c. */
    private static Ride half(double latest, double younger) {
        RideGoal goal = new RideGoal(new Vector3d(0, 0, 0.25), 0.01, 1, Velocity.LARGEST_GAMMA, latest, younger);
        return new Ride(
                "there",
                "Fly.",
                new Vector3d(),
                Velocity.of(0, 0, 0.6),
                1,
                List.of(new RideLeg(0.5, 0.75, new Vector3d(), 0, 0, 1)),
                List.of(goal));
    }

    /** The way from the start is told before, and the verdict after; both have their colours. */
    @Test
    void theBarSaysTheWayToGoAndTheVerdict() {
        Ride ride = half(0.1, 0);
        RidePanel panel = WindowDriver.onEventThread(() -> {
            Look.LIGHT.install();
            return new RidePanel(model, new Settings((Path) null), pilot, () -> {}, studio -> {}, letters -> {});
        });
        JLabel task = Components.find(panel.component(), JLabel.class, "ride.task");
        onEventThread(() -> {
            panel.setShown(true);
            pilot.begin(ride);
            assertThat(task.getText()).isEqualTo("Fly.");
            assertThat(pilot.task().verdict(ride)).isNull();
            pilot.setRiding(true);
        });
        WindowDriver.await("the verdict", () -> pilot.task().verdict(ride) != null);
        onEventThread(() -> {
            pilot.setRiding(false);
            assertThat(task.getText()).endsWith(" on board; 0.1 were allowed: missed");
            assertThat(task.getForeground()).isEqualTo(UIManager.getColor("Tompkins.error"));
            pilot.home();
            assertThat(task.getText()).isEqualTo("Fly.");
            assertThat(task.getForeground()).isEqualTo(UIManager.getColor("Label.foreground"));
            assertThat(pilot.task().verdict(ride).met()).as("still known").isFalse();
            model.open(photograph, null);
            assertThat(pilot.task().verdict(ride)).as("of another scene").isNull();
            assertThat(pilot.moment()).isNull();
        });
    }

    /** A ride without a flight of its own does not lead to that of the photograph, which has its own command. */
    @Test
    void whatWasFlownIsReplayed() {
        Vector3d aside = new Vector3d(1, 0, 0);
        onEventThread(() -> {
            pilot.begin(SECOND);
            pilot.setThrust(aside);
        });
        WindowDriver.await("some way", () -> pilot.moment().properTime() > 0.2);
        onEventThread(() -> {
            pilot.setRiding(false);
            double aboard = pilot.moment().properTime();
            pilot.replay();
            assertThat(pilot.isReplaying()).isTrue();
            assertThat(lens().distance(0, 5, 0)).isLessThan(1e-9);
            assertThat(pilot.task().text()).isEqualTo("Look down.");
            assertThat(aboard).isCloseTo(flownSeconds(), within(1e-9));
        });
        WindowDriver.await("the end", () -> !pilot.isRiding());
        onEventThread(() -> {
            assertThat(pilot.moment().properTime()).isCloseTo(flownSeconds(), within(1e-9));
            pilot.replayScene();
            assertThat(pilot.beginning()).isEqualTo(photograph);
            pilot.setRiding(false);
            // whoever takes over flies anew
            pilot.begin(SECOND);
            assertThat(pilot.beginning().ride()).isEmpty();
        });
    }

    /** Light covers a unit in a second of the second ride. */
    private double flownSeconds() {
        return pilot.beginning().ride().stream().mapToDouble(RideLeg::seconds).sum();
    }

    /** Its legs say where the camera flies as it looks, and its clocks show the time of the photograph. */
    @Test
    void eachRideBeginsAsThePhotographLooksAndWhenItIsTaken() {
        double time = LensEvent.inScene(photograph).time();
        onEventThread(() -> pilot.begin(FIRST));
        WindowDriver.await("some time", () -> pilot.moment().properTime() > 0.1);
        onEventThread(() -> {
            pilot.setRiding(false);
            Camera turned =
                    new Aim(0.5, 0.2).turn(FieldOfView.zoomed(model.studio().camera(), 0.5));
            model.set(model.studio().withCamera(turned));
            pilot.begin(SECOND);
            pilot.setRiding(false);
            Camera camera = model.studio().camera();
            assertThat(LensEvent.inScene(model.studio()).time()).isCloseTo(time, within(1e-9));
            assertThat(camera.viewDirection().angle(photograph.camera().viewDirection()))
                    .isCloseTo(0, within(1e-7));
            assertThat(camera.horizontalAngleDegrees()).isEqualTo(turned.horizontalAngleDegrees());
        });
    }

    /** A brighter or a wider picture is of the same place. */
    @Test
    void anotherLensDoesNotKeepARideFromItsStart() {
        onEventThread(() -> {
            model.set(photograph.withCamera(Descriptions.with(photograph.camera(), "exposureStops", 1.0)));
            pilot.setRiding(true);
            assertThat(pilot.task().text()).isEqualTo("Hold W.");
            assertThat(model.studio().camera().exposureStops()).isEqualTo(1);
        });
    }

    /** Otherwise a challenge would be lost by looking around while it pauses. */
    @Test
    void aRideGoesOnAfterALookAroundInAPause() {
        onEventThread(() -> {
            pilot.begin(SECOND);
            pilot.setThrust(new Vector3d(1, 0, 0));
        });
        WindowDriver.await("some way", () -> pilot.moment().properTime() > 0.1);
        onEventThread(() -> {
            pilot.setRiding(false);
            double aboard = pilot.moment().properTime();
            Studio paused = model.studio();
            model.set(paused.withCamera(FieldOfView.zoomed(paused.camera(), 0.5)));
            pilot.setRiding(true);
            assertThat(pilot.moment().properTime()).isEqualTo(aboard);
            assertThat(pilot.task().text()).isEqualTo("Look down.");
            pilot.setRiding(false);
            // another place is another ride
            model.set(paused.withCamera(CameraMotion.shifted(paused.camera(), new Vector3d(1, 0, 0))));
            assertThat(pilot.moment()).isNull();
        });
    }

    /** Otherwise time is lost while the task is read. */
    @Test
    void aChallengeWaitsForItsRider() {
        RideGoal there = new RideGoal(new Vector3d(0, 0, 1), 0.01, 1, 2, 1, 0);
        onEventThread(() -> {
            pilot.begin(Descriptions.with(FIRST, "challenge", List.of(there)));
            assertThat(pilot.isRiding()).isFalse();
            assertThat(lens().distance(0, 0, -4)).isLessThan(1e-12);
            assertThat(pilot.moment().properTime()).isZero();
            pilot.setRiding(true);
            assertThat(pilot.task().text()).isEqualTo("Hold W.");
        });
        WindowDriver.await("its clock", () -> pilot.moment().properTime() > 0);
    }
}
