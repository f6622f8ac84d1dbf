package tompkins.ui;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.KeyboardFocusManager;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.reflect.InvocationTargetException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executors;
import java.util.concurrent.FutureTask;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JMenuItem;
import javax.swing.JViewport;
import javax.swing.SwingUtilities;
import tompkins.Waiting;
import tompkins.studio.Studio;
import tompkins.ui.picture.Picture;
import tompkins.ui.ride.RidePilot;
import tompkins.ui.widget.Look;

/** Uses a real window as a person does, with mouse and keys: those of its components alone. */
public final class WindowDriver implements AutoCloseable {

    /** Large enough for the panel beside a picture. */
    private static final Dimension SMALL = new Dimension(820, 620);

    private static final int MOST_CLICKS = 5;
    private static final long CLICK_NANOSECONDS = 3_000_000_000L;

    private final ComponentRobot robot = new ComponentRobot();
    private final TompkinsWindow window;

    /**
     * Opens a small window, whose pictures take little time; a test that does this is one that {@link NeedsDisplay}.
     *
     * @param settings the folder of the settings
     */
    WindowDriver(Path settings, Studio studio, Path file, List<Studio> examples) {
        this(withSmallWindow(settings), new FirstScene(studio, file), examples);
    }

    private static Path withSmallWindow(Path settings) {
        Path kept = settings.resolve("window.properties");
        try {
            if (!Files.exists(kept)) {
                Files.createDirectories(settings);
                Files.writeString(kept, "width=" + SMALL.width + "\nheight=" + SMALL.height + "\n");
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return settings;
    }

    /** Opens a window of the usual size, as {@link TompkinsWindow#opened} does, with what it shows first. */
    WindowDriver(Path settings, FirstScene first, List<Studio> examples) {
        System.setProperty("tompkins.settings", settings.toString());
        window = onEventThread(() -> TompkinsWindow.opened(first, () -> examples));
        await("a picture on the screen", () -> picture() != null);
        await("the rest of the window", () -> !window.frame().getIconImages().isEmpty());
        // which keys reach only then
        await("the focus", () -> window.frame().isFocused());
    }

    /** Makes a small window as large as it would usually be. */
    void enlarge() {
        onEventThread(() -> {
            window.frame().setSize(Look.pixels(84), Look.pixels(60));
            window.frame().validate();
        });
        completePicture();
    }

    /** Does something on the event thread, where nothing moves by itself meanwhile, and waits for it. */
    public static void onEventThread(Runnable steps) {
        onEventThread(Executors.callable(steps));
    }

    /** As above, with a result. */
    public static <T> T onEventThread(Callable<T> call) {
        FutureTask<T> task = new FutureTask<>(call);
        try {
            if (SwingUtilities.isEventDispatchThread()) {
                task.run();
            } else {
                SwingUtilities.invokeAndWait(task);
            }
            return task.get();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException(e);
        } catch (InvocationTargetException | ExecutionException e) {
            throw new AssertionError(e.getCause());
        }
    }

    /** Waits until something is true that the event thread is asked for, at most a minute. */
    public static void await(String what, BooleanSupplier condition) {
        Waiting.until(what, () -> onEventThread(condition::getAsBoolean));
    }

    /** Waits until the event thread has done what follows from what the robot did. */
    private void settle() {
        for (int round = 0; round < 2; round++) {
            onEventThread(() -> null);
        }
    }

    TompkinsWindow window() {
        return window;
    }

    Studio studio() {
        return onEventThread(() -> window.model().studio());
    }

    /** Shows a studio as a change of the scene. */
    void set(Studio studio) {
        onEventThread(() -> window.model().set(studio));
    }

    /** Opens a scene; the file is that from which it was read, or null. */
    void open(Studio studio, Path file) {
        onEventThread(() -> window.model().open(studio, file));
    }

    /** What the line at the bottom says. */
    String said() {
        return Components.find(window.frame(), JLabel.class, "status.what").getText();
    }

    RidePilot pilot() {
        return window.motion.pilot();
    }

    /** The components of a type that are on the screen. */
    <C extends Component> Stream<C> showing(Class<C> type) {
        return Components.showing(window.frame(), type);
    }

    Picture picture() {
        return window.view().canvas().shown().now();
    }

    /** Waits until the picture of the current studio is complete on the screen. */
    Picture completePicture() {
        await(
                "the complete picture",
                () -> picture() != null
                        && picture().complete()
                        && picture().isOfSize(window.view().size())
                        && picture().studio().equals(window.model().studio()));
        return picture();
    }

    /** The current studio with a picture of the size that it has on the screen. */
    Studio studioOnScreen() {
        return onEventThread(() -> {
            Dimension size = window.view().size();
            Studio studio = window.model().studio();
            return studio.withSettings(studio.settings().withSize(size.width, size.height));
        });
    }

    <C extends Component> C find(Class<C> type, String name) {
        return onEventThread(() -> Components.find(window.frame(), type, name));
    }

    /** Makes a component visible in its scroll pane, and gives its centre on the screen. */
    Point centre(JComponent component) {
        onEventThread(() -> {
            if (component.getParent() instanceof JComponent parent && !(parent instanceof JViewport)) {
                // a text field keeps such a wish to itself
                parent.scrollRectToVisible(component.getBounds());
            } else {
                component.scrollRectToVisible(new Rectangle(component.getSize()));
            }
        });
        settle();
        return place(component);
    }

    private static Point place(JComponent component) {
        return onEventThread(() -> {
            Point corner = component.getLocationOnScreen();
            Dimension size = component.getSize();
            return new Point(corner.x + size.width / 2, corner.y + size.height / 2);
        });
    }

    void click(JComponent component) {
        Point place = centre(component);
        robot.mouseMove(place.x, place.y);
        // a window manager may move a window some time after it has come up
        for (int tries = 0; tries < MOST_CLICKS && !place(component).equals(place); tries++) {
            place = place(component);
            robot.mouseMove(place.x, place.y);
        }
        press(InputEvent.BUTTON1_DOWN_MASK);
    }

    void click(Point point) {
        robot.mouseMove(point.x, point.y);
        press(InputEvent.BUTTON1_DOWN_MASK);
    }

    private void press(int button) {
        robot.mousePress(button);
        robot.mouseRelease(button);
        settle();
    }

    void doubleClick(Point point) {
        robot.mouseMove(point.x, point.y);
        for (int click = 1; click <= 2; click++) {
            robot.mousePress(InputEvent.BUTTON1_DOWN_MASK, click);
            robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        }
        settle();
    }

    void move(Point point) {
        robot.mouseMove(point.x - 1, point.y);
        robot.mouseMove(point.x, point.y);
        settle();
    }

    /** Drags in steps. */
    void drag(Point from, Point to, int steps) {
        robot.mouseMove(from.x, from.y);
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        for (int i = 1; i <= steps; i++) {
            robot.mouseMove(from.x + (to.x - from.x) * i / steps, from.y + (to.y - from.y) * i / steps);
        }
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        settle();
    }

    /** Turns the wheel by notches towards the user, over a point. */
    void wheel(Point point, int notches) {
        robot.mouseMove(point.x, point.y);
        robot.mouseWheel(notches);
        settle();
    }

    /** Chooses an item of a menu. */
    void menu(String item) {
        later(find(JMenuItem.class, item)::doClick);
    }

    /** Does something on the event thread and does not wait for it: it may open a dialog and wait for that. */
    static void later(Runnable action) {
        SwingUtilities.invokeLater(action);
    }

    /** Waits for a button with a text that is on the screen, such as that of a question, and presses it. */
    void answer(String text) {
        await("the answer " + text, () -> showing(text).isPresent());
        later(onEventThread(() -> showing(text).orElseThrow())::doClick);
    }

    /** Waits until a button with a text has the focus, such as the first answer of a question, and presses Enter. */
    void answerWithEnter(String text) {
        await(
                "the focus on " + text,
                () -> KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner() instanceof JButton button
                        && text.equals(button.getText()));
        key(KeyEvent.VK_ENTER);
    }

    private Optional<JButton> showing(String text) {
        return showing(JButton.class)
                .filter(button -> text.equals(button.getText()))
                .findFirst();
    }

    /** Waits for the file chooser and chooses a file. */
    void choose(Path file) {
        JFileChooser chooser = chooser();
        onEventThread(() -> {
            chooser.setSelectedFile(file.toFile());
            later(chooser::approveSelection);
        });
    }

    /** Waits for the file chooser. */
    JFileChooser chooser() {
        await("the file chooser", this::isChooserOpen);
        return find(JFileChooser.class, "chooser");
    }

    /** Whether the file chooser is on the screen. */
    boolean isChooserOpen() {
        return showing(JFileChooser.class).findAny().isPresent();
    }

    /** Presses a key with modifiers. */
    void key(int code, int... modifiers) {
        for (int modifier : modifiers) {
            robot.keyPress(modifier);
        }
        robot.keyPress(code);
        robot.keyRelease(code);
        for (int modifier : modifiers) {
            robot.keyRelease(modifier);
        }
        settle();
    }

    /** Presses a key with a letter of another script, and Ctrl. */
    void keyWithCtrl(char letter) {
        robot.keyPress(KeyEvent.VK_CONTROL);
        robot.keyPress(letter);
        robot.keyRelease(KeyEvent.VK_CONTROL);
        settle();
    }

    void hold(int code) {
        robot.keyPress(code);
        settle();
    }

    void release(int code) {
        robot.keyRelease(code);
        settle();
    }

    /** Clicks into a field, replaces its text by digits, points and minus signs, and presses Enter. */
    void type(JComponent field, String text) {
        typeWithoutEnter(field, text);
        key(KeyEvent.VK_ENTER);
    }

    /** As above, without the last key. */
    void typeWithoutEnter(JComponent field, String text) {
        // a window that has just come up, or a form that is laid out anew, may miss the first click
        for (int tries = 0; tries < MOST_CLICKS && !onEventThread(field::isFocusOwner); tries++) {
            click(field);
            long end = System.nanoTime() + CLICK_NANOSECONDS;
            await("an answer", () -> field.isFocusOwner() || System.nanoTime() > end);
        }
        await("the focus", field::isFocusOwner);
        key(KeyEvent.VK_A, KeyEvent.VK_CONTROL);
        text.chars().forEach(letter -> key(KeyEvent.getExtendedKeyCodeForChar(letter)));
    }

    @Override
    public void close() {
        onEventThread(() -> window.frame().dispose());
    }
}
