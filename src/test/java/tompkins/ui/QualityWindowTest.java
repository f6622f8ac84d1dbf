package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JTextField;
import org.jfree.chart.ChartPanel;
import org.jfree.chart.entity.EntityCollection;
import org.jfree.chart.entity.XYItemEntity;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tompkins.studio.Studio;

/** The chart of the picture on show, in a real window: it grows while it is measured, and a click on a point is taken. */
@Timeout(300)
class QualityWindowTest {

    private static final int MOST_CLICKS = 5;
    private static final long CLICK_NANOSECONDS = 3_000_000_000L;

    @TempDir
    private Path folder;

    @AutoClose
    private WindowDriver driver;

    @BeforeEach
    void open() {
        Studio studio = Studios.lattice().withSettings(Studio.DEFAULT.settings().withSize(160, 120));
        driver = new WindowDriver(folder, studio, folder.resolve("lattice.json"), List.of(studio));
        JButton measure = driver.find(JButton.class, "Chart this picture");
        WindowDriver.onEventThread(() -> {
            measure.doClick();
            return null;
        });
    }

    @AfterEach
    void closeDialogs() {
        WindowDriver.onEventThread(() -> {
            dialogs().forEach(JDialog::dispose);
            return null;
        });
    }

    @Test
    void aClickOnAPointIsTaken() {
        WindowDriver.await(
                "points of both curves", () -> entity("where needed", 0) != null && entity("the same", 0) != null);
        assertThat(driver.studio().settings().samples()).isEqualTo(1);

        WindowDriver.await(
                "all points", () -> state().startsWith("Click on a point") && entity("where needed", 5) != null);
        choose("the same", 0, "4 samples a pixel");
        assertThat(state()).startsWith("Chosen for the picture:");
        assertThat(driver.studio().settings().samples()).isEqualTo(4);

        JTextField samples = driver.find(JTextField.class, "Samples");
        WindowDriver.onEventThread(() -> {
            samples.setText("3");
            samples.postActionEvent();
            return null;
        });
        assertThat(WindowDriver.onEventThread(QualityWindowTest::state))
                .as("when the scene has another number")
                .startsWith("Click on a point");

        choose("where needed", 5, "Samples where they are needed, error 0.001");
        WindowDriver.await(
                "a picture that is as good",
                () -> driver.picture().complete() && driver.picture().error() <= 0.001);
    }

    @Test
    void escapeClosesTheChart() {
        WindowDriver.await("the focus", () -> dialog().isFocused());
        driver.key(KeyEvent.VK_ESCAPE);
        WindowDriver.await("the end of the chart", () -> dialogs().findAny().isEmpty());
    }

    /** Clicks on a point, and again if the chart was just drawn anew between press and release and took no click. */
    private void choose(String curve, int point, String chosen) {
        for (int click = 0; click < MOST_CLICKS && !isChosen(chosen); click++) {
            driver.click(WindowDriver.onEventThread(() -> place(curve, point)));
            long end = System.nanoTime() + CLICK_NANOSECONDS;
            WindowDriver.await("an answer", () -> state().endsWith(chosen) || System.nanoTime() > end);
        }
        assertThat(WindowDriver.onEventThread(QualityWindowTest::state)).endsWith(chosen);
    }

    private static boolean isChosen(String chosen) {
        return WindowDriver.onEventThread(() -> state().endsWith(chosen));
    }

    private static Stream<JDialog> dialogs() {
        return Stream.of(Window.getWindows())
                .filter(window -> "quality".equals(window.getName()) && window.isVisible())
                .map(JDialog.class::cast);
    }

    private static JDialog dialog() {
        return dialogs().findFirst().orElseThrow();
    }

    private static ChartPanel chart() {
        return Components.find(dialog().getContentPane(), ChartPanel.class, "chart");
    }

    private static String state() {
        return Components.find(dialog().getContentPane(), JLabel.class, "state").getText();
    }

    /** A point of a curve, the cheapest first, or null if it is not there yet. */
    private static XYItemEntity entity(String curve, int point) {
        if (chart().getChart() == null) {
            return null;
        }
        for (Object entity :
                chart().getChartRenderingInfo().getEntityCollection().getEntities()) {
            if (entity instanceof XYItemEntity item
                    && item.getItem() == point
                    && item.getDataset()
                            .getSeriesKey(item.getSeriesIndex())
                            .toString()
                            .startsWith(curve)) {
                return item;
            }
        }
        return null;
    }

    private static Point place(String curve, int point) {
        // the places of the points are those of the last painting, which a new chart may still be waiting for
        chart().paintImmediately(0, 0, chart().getWidth(), chart().getHeight());
        XYItemEntity entity = entity(curve, point);
        Point free = freePlace(entity, entity.getArea().getBounds());
        Point corner = chart().getLocationOnScreen();
        return new Point((int) (corner.x + chart().getInsets().left + free.x * chart().getScaleX()), (int)
                (corner.y + chart().getInsets().top + free.y * chart().getScaleY()));
    }

    /** The place nearest to the centre of a point around which no other point covers it. */
    private static Point freePlace(XYItemEntity entity, Rectangle bounds) {
        return IntStream.range(bounds.x, bounds.x + bounds.width)
                .boxed()
                .flatMap(
                        x -> IntStream.range(bounds.y, bounds.y + bounds.height).mapToObj(y -> new Point(x, y)))
                .filter(place -> isFree(entity, place))
                .min(Comparator.comparingDouble(place -> place.distance(bounds.getCenterX(), bounds.getCenterY())))
                .orElseThrow(() -> new AssertionError("other points cover " + entity));
    }

    private static boolean isFree(XYItemEntity entity, Point place) {
        EntityCollection entities = chart().getChartRenderingInfo().getEntityCollection();
        return IntStream.rangeClosed(-1, 1)
                .allMatch(right -> IntStream.rangeClosed(-1, 1)
                        .allMatch(down -> entities.getEntity(place.x + right, place.y + down) == entity));
    }
}
