package tompkins.ui.ride;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.KeyboardFocusManager;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.beans.PropertyChangeListener;
import java.util.List;
import java.util.Locale;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.ui.WindowDriver;
import tompkins.ui.model.StudioModel;
import tompkins.ui.picture.PictureCanvas;
import tompkins.ui.widget.Look;

/** The keys of a ride, as keyboards of several languages send them; without a display. */
@Timeout(120)
class RideKeysTest {

    private static final int NO_CODE = KeyEvent.VK_UNDEFINED;

    private final StudioModel model = new StudioModel(Studios.sphere().withVelocity(Velocity.REST), null);
    private final RidePilot pilot = new RidePilot(model, text -> {});
    private PictureCanvas canvas;
    private RideKeys keys;

    @BeforeEach
    void ride() {
        Look.LIGHT.install();
        WindowDriver.onEventThread(() -> {
            canvas = new PictureCanvas(room -> {});
            keys = new RideKeys(canvas, pilot, (right, up) -> {});
            pilot.setRiding(true);
        });
    }

    @AfterEach
    void end() {
        WindowDriver.onEventThread(() -> pilot.setRiding(false));
    }

    /** They hang where they hung, however often the ride tells of itself, until it ends. */
    @Test
    void aRideHangsUpItsListenersOnce() {
        WindowDriver.onEventThread(() -> {
            KeyboardFocusManager manager = KeyboardFocusManager.getCurrentKeyboardFocusManager();
            PropertyChangeListener later = event -> {};
            manager.addPropertyChangeListener("focusOwner", later);
            List<PropertyChangeListener> flying = List.of(manager.getPropertyChangeListeners("focusOwner"));
            pilot.home();
            assertThat(manager.getPropertyChangeListeners("focusOwner")).containsExactlyElementsOf(flying);
            pilot.setRiding(false);
            assertThat(manager.getPropertyChangeListeners("focusOwner")).hasSize(flying.size() - 1);
            manager.removePropertyChangeListener("focusOwner", later);
        });
    }

    private void press(int code, char letter, int modifiers) {
        WindowDriver.onEventThread(() -> send(code, letter, modifiers));
    }

    private void send(int code, char letter, int modifiers) {
        KeyEvent event = new KeyEvent(canvas, KeyEvent.KEY_PRESSED, 0, modifiers, code, letter);
        List.of(canvas.getKeyListeners()).forEach(listener -> listener.keyPressed(event));
    }

    /** The direction in which the camera is accelerated from rest. */
    private Vector3d direction() {
        WindowDriver.await("some speed", () -> model.studio().velocity().speed() > 0);
        Vector3dc velocity =
                WindowDriver.onEventThread(() -> model.studio().velocity().proper());
        return new Vector3d(velocity).normalize().round();
    }

    /**
     * The letters in the places of W, A, S, D, Q and E, from the tables of the X Window System (xkeyboard-config: ru,
     * gr), which come without a code.
     */
    @ParameterizedTest
    @CsvSource(
            delimiter = ' ',
            quoteCharacter = '"',
            value = {
                "\u0446 0 0 1",
                "\u0444 -1 0 0",
                "\u044b 0 0 -1",
                "\u0432 1 0 0",
                "\u0439 0 -1 0",
                "\u0443 0 1 0",
                "\u03b1 -1 0 0",
                "W 0 0 1"
            })
    void lettersOfAnyScriptThrust(char letter, double x, double y, double z) {
        press(NO_CODE, letter, 0);
        assertThat(direction()).isEqualTo(new Vector3d(x, y, z));
    }

    /** On an AZERTY keyboard Z is where others have W, Q where they have A, and A where they have Q. */
    @ParameterizedTest
    @CsvSource({"z, 0, 0, 1", "q, -1, 0, 0", "s, 0, 0, -1", "d, 1, 0, 0", "a, 0, -1, 0", "e, 0, 1, 0"})
    void latinLettersCountByTheirKeyboard(char letter, double x, double y, double z) {
        keys.setKeyboard(RideKeyboard.usual(Locale.FRANCE));
        press(Character.toUpperCase(letter), letter, 0);
        assertThat(direction()).isEqualTo(new Vector3d(x, y, z));
    }

    @ParameterizedTest
    @CsvSource({
        "UP, 0, 0, 0, 1",
        "DOWN, 0, 0, 0, -1",
        "LEFT, 64, -1, 0, 0",
        "RIGHT, 64, 1, 0, 0",
        "PAGE_UP, 64, 0, 1, 0",
        "PAGE_DOWN, 64, 0, -1, 0"
    })
    void allDirectionsAreThereWithoutLetters(String key, int modifiers, double x, double y, double z)
            throws ReflectiveOperationException {
        press(KeyEvent.class.getField("VK_" + key).getInt(null), KeyEvent.CHAR_UNDEFINED, modifiers);
        assertThat(direction()).isEqualTo(new Vector3d(x, y, z));
    }

    @Test
    void brakesWithAndWithoutLetters() {
        press(KeyEvent.VK_SPACE, ' ', InputEvent.SHIFT_DOWN_MASK);
        assertThat(pilot.isBraking()).isTrue();
        press(KeyEvent.VK_SPACE, ' ', 0);
        assertThat(pilot.isBraking()).isFalse();
        press(NO_CODE, '\u0438', 0);
        assertThat(pilot.isBraking()).isTrue();
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void homeIsWhereTheRideBegan(boolean paused) {
        Studio start = model.studio();
        press(KeyEvent.VK_W, 'w', 0);
        direction();
        WindowDriver.onEventThread(() -> pilot.setRiding(!paused));
        press(KeyEvent.VK_HOME, KeyEvent.CHAR_UNDEFINED, 0);
        WindowDriver.onEventThread(() -> pilot.setRiding(false));
        assertThat(model.studio().velocity()).isEqualTo(Velocity.REST);
        assertThat(model.studio().camera().position()).isEqualTo(start.camera().position());
    }

    @Test
    void aKeptKeyboardIsFoundByItsLetters() {
        assertThat(RideKeyboard.of("\u0446\u0444\u044b\u0432\u0439\u0443\u0438").name())
                .isEqualTo("Russian");
        assertThat(RideKeyboard.of("")).isEqualTo(RideKeyboard.usual());
        assertThat(RideKeyboard.of("wasdqew")).isEqualTo(RideKeyboard.usual());
    }
}
