package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JTextField;
import javax.swing.JToggleButton;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tompkins.camera.Aim.PicturePosition;
import tompkins.camera.Camera;
import tompkins.io.StudioReader;
import tompkins.spacetime.Velocity;
import tompkins.studio.RideLeg;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.studio.View;
import tompkins.ui.picture.PictureCanvas;
import tompkins.ui.ride.RidePilot;
import tompkins.ui.widget.Texts;

class RideTest extends WindowFixture {

    private Studio start;

    @BeforeEach
    void open() {
        start = Studios.lattice().withVelocity(Velocity.of(0, 0, 0.5));
        driver = new WindowDriver(folder.resolve("settings"), start, null, List.of());
        driver.completePicture();
    }

    private PictureCanvas canvas() {
        return driver.window().view().canvas();
    }

    /** A point of the screen, as shares of the picture. */
    private Point point(double x, double y) {
        return onEventThread(() -> {
            Point corner = canvas().getLocationOnScreen();
            Rectangle bounds = canvas().pictureBounds();
            return new Point(
                    (int) (corner.x + bounds.x + x * bounds.width), (int) (corner.y + bounds.y + y * bounds.height));
        });
    }

    private Vector3d seenAt(Point point, Camera camera) {
        return onEventThread(() -> {
            Point corner = canvas().getLocationOnScreen();
            Rectangle bounds = canvas().pictureBounds();
            return new PicturePosition(
                            (point.x - corner.x + 0.5 - bounds.x) / bounds.width * 640,
                            (point.y - corner.y + 0.5 - bounds.y) / bounds.height * 480,
                            640,
                            480)
                    .direction(camera);
        });
    }

    private double pixelsBetween(Vector3d direction, Vector3d other, Camera camera) {
        Vector2dc one = PicturePosition.of(camera, direction, 640, 480).get(0);
        return one.distance(PicturePosition.of(camera, other, 640, 480).get(0));
    }

    @Test
    void dragsWheelAndKeysSteerTheView() {
        Point from = point(0.7, 0.4);
        Point to = point(0.4, 0.6);
        Vector3d seen = seenAt(from, start.camera());
        driver.drag(from, to, 12);
        Camera dragged = driver.studio().camera();
        assertThat(pixelsBetween(seen, seenAt(to, dragged), dragged)).isLessThan(0.01);
        assertThat(driver.window().side.component().isShowing()).isTrue();

        Point pointer = point(0.3, 0.3);
        Vector3d under = seenAt(pointer, dragged);
        driver.wheel(pointer, -3);
        Camera zoomed = driver.studio().camera();
        assertThat(zoomed.horizontalAngleDegrees()).isCloseTo(20 / Math.pow(1.1, 3), within(1e-9));
        assertThat(pixelsBetween(under, seenAt(pointer, zoomed), zoomed)).isLessThan(0.01);

        driver.key(KeyEvent.VK_RIGHT, KeyEvent.VK_ALT);
        Camera turned = driver.studio().camera();
        assertThat(Math.toDegrees(turned.viewDirection().angle(zoomed.viewDirection())))
                .isCloseTo(0.05 * zoomed.horizontalAngleDegrees(), within(0.02));

        // one step for each gesture
        driver.key(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
        assertThat(driver.studio().camera()).isEqualTo(zoomed);
        driver.key(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
        assertThat(driver.studio().camera()).isEqualTo(dragged);
        driver.key(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
        assertThat(driver.studio()).isEqualTo(start);
    }

    @Test
    void shiftDragMovesTheLensWithWhatIsUnderTheMouse() {
        driver.hold(KeyEvent.VK_SHIFT);
        driver.drag(point(0.5, 0.5), point(0.6, 0.5), 8);
        driver.release(KeyEvent.VK_SHIFT);
        Camera moved = driver.studio().camera();
        assertThat(moved.position().x()).isLessThan(-0.01);
        assertThat(moved.viewDirection()).isEqualTo(start.camera().viewDirection());
        assertThat(driver.studio().velocity()).isEqualTo(start.velocity());
        double before = moved.position().z();
        driver.hold(KeyEvent.VK_CONTROL);
        driver.wheel(point(0.5, 0.5), -2);
        driver.release(KeyEvent.VK_CONTROL);
        await("the lens nearer", () -> driver.studio().camera().position().z() > before + 0.01);
    }

    @Test
    void doubleClickCentres() {
        Point at = point(0.7, 0.3);
        Vector3d seen = seenAt(at, start.camera());
        driver.doubleClick(at);
        await("the view on it", () -> driver.studio().camera().viewDirection().angle(seen) < 1e-6);
    }

    @Test
    void recordedRideIsKeptAndReplayed() {
        driver.key(KeyEvent.VK_F6);
        driver.key(KeyEvent.VK_F6);
        more();
        driver.click(driver.find(JToggleButton.class, "Record"));
        driver.hold(KeyEvent.VK_S);
        await("a slower camera", () -> driver.studio().velocity().rapidity() < 0.549 - 0.1);
        driver.release(KeyEvent.VK_S);
        driver.key(KeyEvent.VK_F6);
        await("the recording", () -> !driver.studio().ride().isEmpty());
        Studio recorded = driver.studio();
        double change = recorded.ride().stream()
                .mapToDouble(leg -> leg.acceleration().z() * leg.properTime())
                .sum();
        assertThat(change).isLessThan(-0.1);
        double rapidity = recorded.velocity().rapidity();

        replay();
        Studio end = driver.studio();
        double signed = end.velocity().rapidity()
                * Math.signum(end.velocity().direction().z());
        assertThat(signed).isCloseTo(rapidity + change, within(1e-9));
        driver.key(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
        assertThat(driver.studio()).isEqualTo(recorded);
    }

    /** Shows all of the bar. */
    private void more() {
        JToggleButton button = driver.find(JToggleButton.class, "More");
        await("the bar", button::isShowing);
        onEventThread(() -> {
            if (!button.isSelected()) {
                button.doClick();
            }
        });
    }

    /** Replays a ride to its end, which may be there before anybody looks. */
    private void replay() {
        RidePilot pilot = driver.pilot();
        AtomicBoolean replayed = new AtomicBoolean();
        onEventThread(() -> pilot.addListener(() -> replayed.compareAndSet(false, pilot.isReplaying())));
        more();
        driver.click(driver.find(JButton.class, "Replay"));
        await("the replay", replayed::get);
        await("its end", () -> !pilot.isRiding());
    }

    /** A ride by hand takes the camera away from where the recorded one begins, which can still be seen. */
    @Test
    void theRecordedRideIsThereAfterOneByHand() {
        driver.close();
        Studio withRide = start.withRide(List.of(new RideLeg(0.3, 0.3, new Vector3d(0, 0, 1), 0, 0, 1)));
        driver = new WindowDriver(folder.resolve("settings"), withRide, null, List.of());
        driver.key(KeyEvent.VK_F6);
        RidePilot pilot = driver.pilot();
        await("a ride", () -> pilot.moment() != null && pilot.moment().properTime() > 0.1);
        JButton replay = driver.find(JButton.class, "Replay");
        assertThat(replay.isEnabled()).isTrue();

        replay();

        assertThat(driver.window().view().canvas().isFocusOwner())
                .as("the keys steer")
                .isTrue();
        // thrust of 1 for a time of 0.3
        assertThat(driver.studio().velocity().rapidity())
                .isCloseTo(start.velocity().rapidity() + 0.3, within(1e-9));
    }

    /** Behind a question nothing moves, and the picture that is saved is the one behind it. */
    @Test
    void aQuestionPausesARide() {
        RidePilot pilot = driver.pilot();
        driver.key(KeyEvent.VK_F6);
        driver.hold(KeyEvent.VK_W);
        await("thrust", () -> driver.studio().velocity().speed() > 0.51);
        driver.release(KeyEvent.VK_W);
        driver.menu("menu.savePhotograph");
        driver.chooser();
        assertThat(onEventThread(pilot::isRiding)).isFalse();
        Studio seen = driver.completePicture().studio();
        Path file = folder.resolve("seen.png");
        driver.choose(file);
        await("the photograph", () -> Files.exists(file));
        assertThat(StudioReader.read(file)).isEqualTo(seen);

        driver.key(KeyEvent.VK_F6);
        await("the ride", pilot::isRiding);
        driver.menu("menu.about");
        await("the pause", () -> !pilot.isRiding());
        driver.answer("OK");
    }

    @Test
    void rideBeginsWhereverTheFocusIs() {
        driver.click(driver.find(JTextField.class, "Speed"));
        driver.key(KeyEvent.VK_F6);
        await("the ride", () -> driver.pilot().isRiding());
        driver.hold(KeyEvent.VK_W);
        await("thrust", () -> driver.studio().velocity().direction().z() > 0.01);
        driver.release(KeyEvent.VK_W);
        driver.click(driver.find(JButton.class, Texts.get("panel.ride")));
        assertThat(driver.pilot().isRiding()).isFalse();
    }

    /** Otherwise no key would do anything after a click at a switch, and nobody would know why. */
    @Test
    void keysSteerAfterAClickAtASwitch() {
        driver.key(KeyEvent.VK_F6);
        more();
        JComboBox<?> view = driver.find(JComboBox.class, "View");
        onEventThread(() -> view.setSelectedItem(View.MEASURED));
        assertThat(driver.studio().view()).isEqualTo(View.MEASURED);
        double before = driver.studio().velocity().speed();
        driver.hold(KeyEvent.VK_W);
        await("thrust", () -> driver.studio().velocity().speed() > before + 0.01);
        driver.release(KeyEvent.VK_W);
        driver.key(KeyEvent.VK_SPACE);
        // what is typed into a field is no thrust
        driver.click(driver.find(JTextField.class, "Speed"));
        driver.key(KeyEvent.VK_B);
        assertThat(onEventThread(() -> driver.pilot().isBraking())).isFalse();
    }
}
