package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Dialog;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JEditorPane;
import javax.swing.JFileChooser;
import javax.swing.JSlider;
import javax.swing.KeyStroke;
import javax.swing.MenuSelectionManager;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tompkins.Thorough;
import tompkins.io.BundledScenes;
import tompkins.studio.Studio;
import tompkins.ui.picture.PictureCanvas;

/**
 * Somebody presses whatever there is, with mouse and keys, and nothing fails. {@code -Dtompkins.seed} chooses other
 * actions, and {@code -Dtompkins.actions=5000} more: some minutes.
 */
@Timeout(1200)
@NeedsDisplay
@Thorough
class MonkeyTest {

    private static final int USUALLY = 80;

    /** Begins the names of what would end the program, or change what other programs see. */
    private static final List<String> SPARED = List.of("menu.close", "menu.copy");

    private static final int[] KEYS =
            keys("TAB ENTER SPACE ESCAPE UP DOWN LEFT RIGHT HOME END PAGE_UP PAGE_DOWN DELETE BACK_SPACE"
                    + " W S A D B 0 9 PERIOD MINUS F1 F3 F4 F5 F6 F7 F8 F11 F12");

    /** Keys for Control: undo, redo, editor, animation, map, zoom. */
    private static final int[] WITH_CONTROL = keys("Z Y E L M 0 LEFT");

    private final List<Throwable> failures = Collections.synchronizedList(new ArrayList<>());
    private final Deque<String> last = new ArrayDeque<>();

    @TempDir
    private Path folder;

    private Random random;

    private static int[] keys(String names) {
        return Stream.of(names.split(" "))
                .mapToInt(name -> KeyStroke.getKeyStroke(name).getKeyCode())
                .toArray();
    }

    @Test
    void whateverIsPressedNothingFails() throws Exception {
        long seed = Long.getLong("tompkins.seed", 49);
        random = new Random(seed);
        Thread.UncaughtExceptionHandler before = Thread.getDefaultUncaughtExceptionHandler();
        Thread.setDefaultUncaughtExceptionHandler((thread, failure) -> failures.add(failure));
        try {
            int left = Integer.getInteger("tompkins.actions", USUALLY);
            while (left > 0 && failures.isEmpty()) {
                try (WindowDriver driver = new WindowDriver(folder, scene(), null, List.of(scene(), scene()))) {
                    while (left > 0
                            && failures.isEmpty()
                            && driver.window().frame().isDisplayable()) {
                        act(driver);
                        left--;
                    }
                }
            }
        } finally {
            Thread.setDefaultUncaughtExceptionHandler(before);
        }
        assertThat(failures).as("seed %s, after %s", seed, last).isEmpty();
    }

    private Studio scene() throws IOException {
        String[] names = {"terrell-cube.json", "motion-tram.json", "lesson-02-turned-cube.json", "flash-echo.json"};
        Studio scene = BundledScenes.studio(names[random.nextInt(names.length)]);
        return scene.withSettings(scene.settings().withSize(64, 48).withSamples(1));
    }

    private void note(String action) {
        last.add(action);
        if (last.size() > 12) {
            last.remove();
        }
    }

    private void act(WindowDriver driver) {
        // no file outside the folder of the test is touched
        WindowDriver.onEventThread(() -> {
            windows().stream()
                    .flatMap(window -> Components.all(window))
                    .filter(part -> part instanceof JFileChooser && part.isShowing())
                    .forEach(part -> ((JFileChooser) part).cancelSelection());
        });
        int choice = random.nextInt(10);
        if (choice < 3) {
            int[] keys = choice == 0 ? WITH_CONTROL : KEYS;
            int key = keys[random.nextInt(keys.length)];
            note("key " + (choice == 0 ? "Ctrl+" : "") + KeyEvent.getKeyText(key));
            if (choice == 0) {
                driver.key(key, KeyEvent.VK_CONTROL);
            } else {
                driver.key(key);
            }
        } else {
            point(driver, choice);
        }
    }

    /** Uses the mouse at a random part of the windows. */
    private void point(WindowDriver driver, int choice) {
        Rectangle part = WindowDriver.onEventThread(this::anyPart);
        if (part == null) {
            return;
        }
        Point from = in(part);
        if (choice < 8) {
            driver.click(from);
        } else if (choice == 8) {
            driver.drag(from, in(part), 3);
        } else {
            driver.wheel(from, random.nextBoolean() ? 1 : -1);
        }
    }

    private Point in(Rectangle part) {
        return new Point(part.x + random.nextInt(part.width), part.y + random.nextInt(part.height));
    }

    private List<Window> windows() {
        List<Window> showing = new ArrayList<>();
        for (Window window : Window.getWindows()) {
            if (window.isShowing()) {
                showing.add(window);
            }
        }
        List<Window> modal = showing.stream()
                .filter(window -> window instanceof Dialog dialog && dialog.isModal())
                .toList();
        return modal.isEmpty() ? showing : modal;
    }

    private Rectangle anyPart() {
        List<Component> parts = windows().stream()
                .flatMap(window -> Components.all(window))
                .filter(part -> part.isShowing() && part.isEnabled() && isUsed(part))
                .filter(part -> !((JComponent) part).getVisibleRect().isEmpty())
                .toList();
        if (parts.isEmpty()) {
            MenuSelectionManager.defaultManager().clearSelectedPath();
            return null;
        }
        JComponent part = (JComponent) parts.get(random.nextInt(parts.size()));
        note(part.getClass().getSimpleName() + " " + part.getAccessibleContext().getAccessibleName());
        Rectangle visible = part.getVisibleRect();
        Point corner = part.getLocationOnScreen();
        visible.translate(corner.x, corner.y);
        return visible;
    }

    private static boolean isUsed(Component part) {
        return SPARED.stream().noneMatch(String.valueOf(part.getName())::startsWith)
                && !(part instanceof JEditorPane)
                && (part instanceof AbstractButton
                        || part instanceof JComboBox
                        || part instanceof JSlider
                        || part instanceof JTextComponent
                        || part instanceof PictureCanvas);
    }
}
