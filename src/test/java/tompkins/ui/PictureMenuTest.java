package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Component;
import java.awt.Container;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.util.List;
import javax.swing.JMenuItem;
import javax.swing.JTextArea;
import javax.swing.JTree;
import javax.swing.MenuSelectionManager;
import org.joml.Vector3d;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tompkins.camera.FocusDistance;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.Velocity;
import tompkins.studio.LensEvent;
import tompkins.studio.Studio;
import tompkins.surface.ColouredSurface;
import tompkins.ui.picture.PictureCanvas;
import tompkins.ui.widget.Texts;

/** What can be done with what is seen at a place of the picture. */
class PictureMenuTest extends WindowFixture {

    private PictureCanvas canvas;

    /** A ball of radius 1 straight ahead, and one to the right of it. */
    @BeforeEach
    void open() {
        Studio studio = Studio.DEFAULT
                .withScene(List.of(
                        new Sphere("middle", new Vector3d(0, 0, 11), 1, ColouredSurface.DEFAULT),
                        new Sphere("right", new Vector3d(2.5, 0, 11), 1, ColouredSurface.DEFAULT)))
                .withVelocity(Velocity.of(0, 0, 0.6));
        driver = new WindowDriver(folder, studio, null, List.of());
        canvas = driver.find(PictureCanvas.class, "picture");
        driver.completePicture();
        onEventThread(() -> canvas.requestFocusInWindow());
        await("the focus", canvas::isFocusOwner);
    }

    /** The item of the menu that keys ask for in the middle of the picture. */
    private JMenuItem item(String key) {
        driver.key(KeyEvent.VK_F10, KeyEvent.VK_SHIFT);
        await("the menu", () -> MenuSelectionManager.defaultManager().getSelectedPath().length > 0);
        return onEventThread(() -> {
            Component popup =
                    MenuSelectionManager.defaultManager().getSelectedPath()[0].getComponent();
            return Components.find((Container) popup, JMenuItem.class, Texts.get("picture." + key));
        });
    }

    private void choose(String key) {
        JMenuItem item = item(key);
        onEventThread(() -> {
            MenuSelectionManager.defaultManager().clearSelectedPath();
            item.doClick();
        });
    }

    private String chosenInTheEditor() {
        return Components.all(driver.window().frame())
                .filter(JTree.class::isInstance)
                .map(tree -> ((JTree) tree).getSelectionPath())
                .map(String::valueOf)
                .findFirst()
                .orElse("");
    }

    @Test
    void theEditorFollowsClicks() {
        choose("edit");
        await("the editor", () -> chosenInTheEditor().contains("middle"));
        onEventThread(() -> press(MouseEvent.BUTTON1, right()));
        await("the other ball", () -> chosenInTheEditor().contains("right"));
    }

    /** Where the right ball is seen: a moving camera sees it at half of tan(a/2), as D = 2. */
    private Point right() {
        double angle = 2 * Math.atan(Math.tan(Math.atan2(2.5, 11) / 2) / 2);
        Rectangle bounds = canvas.pictureBounds();
        double half = Math.tan(Math.toRadians(driver.studio().camera().horizontalAngleDegrees()) / 2);
        return new Point(
                (int) (bounds.getCenterX() + Math.tan(angle) / half * bounds.width / 2), (int) bounds.getCenterY());
    }

    private void press(int button, Point point) {
        boolean asks = button == MouseEvent.BUTTON3;
        int down = InputEvent.getMaskForButton(button);
        canvas.dispatchEvent(event(MouseEvent.MOUSE_PRESSED, point, down, button, asks));
        canvas.dispatchEvent(event(MouseEvent.MOUSE_RELEASED, point, 0, button, false));
    }

    private MouseEvent event(int kind, Point point, int down, int button, boolean asks) {
        return new MouseEvent(canvas, kind, System.currentTimeMillis(), down, point.x, point.y, 1, asks, button);
    }

    /** Nine tenths of the way to the ball, whose front is 10 away, at the same time of the scene. */
    @Test
    void aRideBeginsBeforeWhatIsSeen() {
        double time = LensEvent.inScene(driver.studio()).time();
        choose("rideFrom");
        await("the ride", () -> driver.pilot().isRiding());
        onEventThread(() -> driver.pilot().setRiding(false));
        Studio ridden = driver.studio();
        assertThat(ridden.velocity().isRest()).isTrue();
        assertThat(LensEvent.inScene(ridden).position().distance(new Vector3d(0, 0, 9)))
                .isCloseTo(0, within(0.01));
        assertThat(LensEvent.inScene(ridden).time()).isGreaterThanOrEqualTo(time);
    }

    /** The light began 10 away in the scene; in the camera frame that is D = 2 times as far. */
    @Test
    void theCameraIsFocusedOnWhatIsSeen() {
        choose("focus");
        await("another focus", () -> driver.window().model().isModified());
        assertThat(FocusDistance.of(driver.studio().camera())).isCloseTo(20, within(1e-3));
    }

    @Test
    void theMouseAsksForTheMenu() {
        Point point = onEventThread(this::right);
        onEventThread(() -> press(MouseEvent.BUTTON3, point));
        await("the menu", () -> MenuSelectionManager.defaultManager().getSelectedPath().length > 0);
        driver.key(KeyEvent.VK_ESCAPE);
        choose("lookAt");
        await("the turn", () -> driver.studio().camera().viewDirection().x() > 0.1);
    }

    @Test
    void measuringBeginsAtThePoint() {
        choose("measureFrom");
        JTextArea results = driver.find(JTextArea.class, "measure.results");
        assertThat(results.getText()).isEqualTo("Click on two points in the picture.");
        onEventThread(() -> press(MouseEvent.BUTTON1, right()));
        await("the angle", () -> results.getText().startsWith("angle: "));
    }
}
