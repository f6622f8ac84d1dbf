package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.AWTEvent;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Insets;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.event.AWTEventListener;
import java.awt.event.ComponentEvent;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import javax.swing.JComponent;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tompkins.property.Descriptions;
import tompkins.studio.Studio;
import tompkins.studio.Studios;

/** How the panel comes into a window that is there already. */
@Timeout(300)
@NeedsDisplay
class FoldingPanelTest {

    /** Its remarks take several lines in the panel. */
    private static final Studio SCENE = Descriptions.with(Studios.sphere(), "remarks", "Look at this. ".repeat(20));

    @TempDir
    private Path folder;

    private TompkinsWindow window;

    @BeforeEach
    void useOwnSettings() {
        System.setProperty("tompkins.settings", folder.toString());
    }

    @AfterEach
    void close() {
        WindowDriver.onEventThread(() -> window.frame().dispose());
    }

    private void open() {
        window = TompkinsWindow.opened(new FirstScene(SCENE, null), List::of);
    }

    @Test
    void thePanelComesLaterAndMovesNothing() {
        Rectangle room = WindowDriver.onEventThread(() -> {
            open();
            assertThat(window.side().isThere()).isFalse();
            return roomBesidePicture();
        });
        WindowDriver.await("the panel", () -> window.side().isThere());
        assertThat(WindowDriver.onEventThread(this::roomBesidePicture)).isEqualTo(room);
    }

    /** What is laid out again and again keeps a processor busy as long as the window is open. */
    @Test
    void remarksComeToRest() throws InterruptedException {
        AtomicInteger sizes = new AtomicInteger();
        AWTEventListener listener = event -> {
            if (event.getID() == ComponentEvent.COMPONENT_RESIZED && "remarks".equals(name(event))) {
                sizes.incrementAndGet();
            }
        };
        Toolkit.getDefaultToolkit().addAWTEventListener(listener, AWTEvent.COMPONENT_EVENT_MASK);
        try {
            WindowDriver.onEventThread(this::open);
            WindowDriver.await("the remarks", () -> sizes.get() > 0);
            Thread.sleep(500);
            assertThat(sizes).hasValueLessThan(10);
        } finally {
            Toolkit.getDefaultToolkit().removeAWTEventListener(listener);
        }
    }

    private static String name(AWTEvent event) {
        return ((Component) event.getSource()).getName();
    }

    /** Where the picture is, and what the window leaves to the right of it and below, whatever borders it gets. */
    private Rectangle roomBesidePicture() {
        window.frame().validate();
        Rectangle picture = window.view().canvas().getBounds();
        Dimension all = window.frame().getContentPane().getSize();
        return new Rectangle(picture.x, picture.y, all.width - picture.width, all.height - picture.height);
    }

    @Test
    void thePanelHasItsPlaceAndItsHeightsAsSoonAsItIsSeen() {
        AtomicReference<List<Rectangle>> first = new AtomicReference<>();
        WindowDriver.onEventThread(() -> {
            open();
            JComponent panel = window.side().panel().component();
            panel.addHierarchyListener(event -> {
                if (panel.isShowing() && first.get() == null) {
                    // as it is done before it is painted
                    window.frame().validate();
                    panel.validate();
                    first.set(places());
                }
            });
        });
        WindowDriver.await("the panel", () -> window.side().isThere());
        WindowDriver.onEventThread(() -> {
            window.frame().validate();
            window.side().panel().component().validate();
        });
        assertThat(first.get()).isEqualTo(WindowDriver.onEventThread(this::places));
    }

    private List<Rectangle> places() {
        JComponent panel = window.side().panel().component();
        JTextField field = Components.find(panel, JTextField.class, "Opening time");
        Rectangle place = SwingUtilities.convertRectangle(field.getParent(), field.getBounds(), panel);
        return List.of(panel.getBounds(), place);
    }

    /** The window has as much room as the smallest screens. */
    @Test
    void thePanelFoldsWhereThePictureHasNoRoom() {
        WindowDriver.onEventThread(this::open);
        WindowDriver.await("the panel", () -> window.side().isThere());
        int panel = WindowDriver.onEventThread(() -> window.side().component().getPreferredSize().width);
        assertThat(WindowDriver.onEventThread(() -> window.frame().getMinimumSize()))
                .matches(least -> least.width <= 683 && least.height <= 384, "fits on 1366 x 768 at scale 2");
        resize(800, 600);
        assertThat(isPanelVisible()).isTrue();
        resize(panel + 100, 600);
        assertThat(isPanelVisible()).isFalse();
        // somebody wants it all the same
        WindowDriver.onEventThread(() -> window.side().toggle());
        resize(panel + 120, 600);
        assertThat(isPanelVisible()).isTrue();
        WindowDriver.onEventThread(() -> window.side().toggle());
        resize(1000, 600);
        assertThat(isPanelVisible()).as("was hidden by hand").isFalse();
        WindowDriver.onEventThread(() -> window.side().toggle());
        resize(panel + 100, 600);
        resize(1000, 600);
        assertThat(isPanelVisible()).as("comes back").isTrue();
    }

    private boolean isPanelVisible() {
        return WindowDriver.onEventThread(() -> window.side().component().isVisible());
    }

    private void resize(int width, int height) {
        WindowDriver.onEventThread(() -> {
            Insets borders = window.frame().getInsets();
            window.frame().setMinimumSize(new Dimension(1, 1));
            window.frame().setSize(width + borders.left + borders.right, height);
            window.frame().validate();
        });
        WindowDriver.await(
                "the other size", () -> window.frame().getContentPane().getWidth() == width);
        // what hears of it
        WindowDriver.onEventThread(() -> {});
        WindowDriver.onEventThread(() -> {});
    }

    @Test
    void whoNeedsThePanelDoesNotWaitForIt() {
        WindowDriver.onEventThread(() -> {
            open();
            SidePanel panel = window.side().panel();
            assertThat(panel.component().getParent()).isSameAs(window.side().component());
            assertThat(window.side().panel()).isSameAs(panel);
        });
        WindowDriver.await("the panel", () -> window.side().isThere());
    }
}
