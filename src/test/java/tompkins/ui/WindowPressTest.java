package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Point;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JTextField;
import javax.swing.JToggleButton;
import org.joml.Vector3d;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.ui.picture.PictureCanvas;
import tompkins.ui.widget.Texts;

/** What a press of the mouse does while something is half typed, or to what has the focus, in a real window. */
class WindowPressTest extends WindowFixture {

    private JTextField speed;

    @BeforeEach
    void open() {
        Studio studio = Studios.lattice()
                .withVelocity(Velocity.of(0, 0, 0.3))
                .withSettings(Studio.DEFAULT.settings().withSize(160, 120));
        driver = new WindowDriver(folder, studio, folder.resolve("lattice.json"), List.of(studio));
        speed = driver.find(JTextField.class, "Speed");
    }

    /** The focus moves only after such a click. */
    private void clickWithoutTimeBetween(JComponent button) {
        onEventThread(() -> {
            Components.mouse(button, MouseEvent.MOUSE_PRESSED, 5, 5);
            Components.mouse(button, MouseEvent.MOUSE_RELEASED, 5, 5);
        });
        await("the focus", button::isFocusOwner);
    }

    private boolean complains() {
        return Components.notes(driver.window().frame()).stream().anyMatch(note -> note.startsWith("\u26A0"));
    }

    @Test
    void aQuickClickComesAfterWhatIsTyped() {
        driver.typeWithoutEnter(speed, "0.5");
        clickWithoutTimeBetween(driver.find(JToggleButton.class, Texts.get("panel.all")));
        assertThat(driver.window().side.isEditing()).isTrue();
        assertThat(driver.studio().velocity().speed()).isEqualTo(0.5);
        clickWithoutTimeBetween(driver.find(JToggleButton.class, Texts.get("panel.all")));
        assertThat(speed.getText()).isEqualTo("0.5");
    }

    @Test
    void whatIsPressedDoesNotMoveAway() {
        JTextField below = driver.find(JTextField.class, "Aperture");
        driver.typeWithoutEnter(speed, "1.2");
        Point before = onEventThread(below::getLocationOnScreen);
        onEventThread(() -> Components.mouse(below, MouseEvent.MOUSE_PRESSED, 5, 5));
        await("the focus", below::isFocusOwner);
        await("the mark", () -> Components.isMarked(speed));
        onEventThread(driver.window().frame()::validate);
        assertThat(onEventThread(below::getLocationOnScreen)).isEqualTo(before);
        onEventThread(() -> Components.mouse(below, MouseEvent.MOUSE_RELEASED, 5, 5));
        await("the message", this::complains);
        assertThat(driver.studio().velocity().components()).isEqualTo(new Vector3d(0, 0, 0.3));

        // nor when the message goes
        driver.typeWithoutEnter(speed, "0.4");
        Point after = onEventThread(below::getLocationOnScreen);
        assertThat(after).as("there was room for the message").isEqualTo(before);
        onEventThread(() -> Components.mouse(below, MouseEvent.MOUSE_PRESSED, 5, 5));
        await("the focus", below::isFocusOwner);
        onEventThread(driver.window().frame()::validate);
        assertThat(onEventThread(below::getLocationOnScreen)).isEqualTo(after);
        onEventThread(() -> Components.mouse(below, MouseEvent.MOUSE_RELEASED, 5, 5));
        await("no message", () -> !complains());
    }

    @Test
    void theRingWaitsForAKey() {
        PictureCanvas canvas = driver.find(PictureCanvas.class, "picture");
        JLabel what = driver.find(JLabel.class, "status.where");
        driver.click(canvas);
        JButton unpin = driver.find(JButton.class, "Unpin");
        await("the pinned pixel", unpin::isShowing);
        driver.move(driver.centre(speed));
        await("no reading", () -> what.getText().isBlank());
        driver.click(unpin);
        await("the focus", canvas::isFocusOwner);
        onEventThread(() -> assertThat(what.getText()).isBlank());
        driver.key(KeyEvent.VK_RIGHT);
        await("a reading", () -> what.getText().contains("Doppler factor"));
    }
}
