package tompkins.ui.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.ActionEvent;
import java.awt.event.MouseEvent;
import java.awt.geom.Point2D;
import java.beans.PropertyChangeEvent;
import java.beans.PropertyChangeListener;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import javax.swing.KeyStroke;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.shutter.DetectorPlaneShutter;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.ui.Components;

/** The keys and the mouse on a picture that has more pixels than the canvas, without a display. */
class PictureCanvasTest {

    private static final int WIDTH = 200;
    private static final int HEIGHT = 150;

    private final List<Room> sizes = new ArrayList<>();
    private final List<Point2D> read = new ArrayList<>();
    private final List<Point2D> clicked = new ArrayList<>();
    private final PictureCanvas canvas = canvas();

    private PictureCanvas canvas() {
        PictureCanvas made = new PictureCanvas(sizes::add);
        made.setSize(WIDTH / 2, HEIGHT / 2);
        made.setMouse(new PictureCanvas.Mouse() {
            @Override
            public void over(Point2D place, Picture seen, boolean rests) {
                read.add(place);
            }

            @Override
            public void asksForMenu(Point2D place, Picture seen, Point at) {}
        });
        made.setTool(new PictureTool() {
            @Override
            public boolean isWanted() {
                return true;
            }

            @Override
            public String hint() {
                return "";
            }

            @Override
            public void click(Point2D place, Picture seen) {
                clicked.add(place);
            }
        });
        made.show(pictures(Studio.DEFAULT));
        return made;
    }

    private static ScreenPicture pictures(Studio studio) {
        Picture picture = Pictures.black(studio.withSettings(studio.settings().withSize(WIDTH, HEIGHT)));
        return new ScreenPicture(picture, picture.levels(), null, null, null);
    }

    private void press(String key) {
        Object action = canvas.getInputMap().get(KeyStroke.getKeyStroke(key));
        canvas.getActionMap().get(action).actionPerformed(new ActionEvent(canvas, ActionEvent.ACTION_PERFORMED, key));
    }

    private void mouse(int event, Point at) {
        Components.mouse(canvas, event, at.x, at.y);
    }

    private Point2D lastRead() {
        return read.get(read.size() - 1);
    }

    /** A picture that is black, and brighter where something is written. */
    private Rectangle written() {
        canvas.setSize(WIDTH, HEIGHT);
        int[] painted = Pictures.painted(canvas);
        return Pictures.around(WIDTH, HEIGHT, i -> (painted[i] & 0xff) > 128);
    }

    @Test
    void wantedCaptionsStandInTheLowerLeftCorner() {
        assertThat(written().isEmpty()).isTrue();
        canvas.setCaptions(studio -> studio.velocity().speed() == 0 ? "IIII" : "");
        Rectangle caption = written();
        assertThat(caption.x).isLessThan(WIDTH / 4);
        assertThat(caption.y).isGreaterThan(HEIGHT * 3 / 4);
        assertThat(caption.getMaxY()).isLessThan(HEIGHT);
        canvas.setCaptions(null);
        assertThat(written().isEmpty()).isTrue();
    }

    /** A map, for example, must not cover the caption. */
    @Test
    void overlaysAreToldOfTheRoomAboveTheCaption() {
        List<Rectangle> rooms = new ArrayList<>();
        canvas.addOverlay((g, picture, bounds, visible, free) -> rooms.add(free));
        written();
        canvas.setCaptions(studio -> "IIII");
        Rectangle caption = written();
        assertThat(rooms.get(0).getMaxY()).isEqualTo(HEIGHT);
        assertThat(rooms.get(rooms.size() - 1).getMaxY()).isLessThanOrEqualTo(caption.y);
        assertThat(rooms.get(rooms.size() - 1).y).isZero();
    }

    /** "Now" would not say which of two shutters it is. */
    @Test
    void picturesOfTwoShuttersAreCalledByThem() {
        Picture lens = pictures(Studio.DEFAULT).now();
        Studio other = Studio.DEFAULT.withCamera(Studio.DEFAULT.camera().withShutter(DetectorPlaneShutter.DEFAULT));
        Picture detector = pictures(other).now();
        assertThat(new ScreenPicture(lens, null, detector, null, null).nameOfNow())
                .isEqualTo("Aperture plane");
        assertThat(new ScreenPicture(detector, null, lens, null, null).nameOfNow())
                .isEqualTo("Detector plane");
        assertThat(new ScreenPicture(lens, null, lens, null, null).nameOfNow()).isEqualTo("Now");
    }

    @Test
    void eachOfTwoPicturesHasItsOwnCaption() {
        Picture now = pictures(Studio.DEFAULT).now();
        Picture other =
                pictures(Studio.DEFAULT.withVelocity(Velocity.of(0, 0, 0.5))).now();
        canvas.show(new ScreenPicture(now, now.levels(), other, other.levels(), null));
        canvas.setComparison(Comparison.SPLIT, "");
        List<Studio> asked = new ArrayList<>();
        canvas.setCaptions(studio -> {
            asked.add(studio);
            return "";
        });
        written();
        assertThat(asked).containsOnly(now.studio(), other.studio());
    }

    @Test
    void theKeysReachAllPixels() {
        int middle = WIDTH / 2;
        IntStream.range(0, 10).forEach(i -> press("RIGHT"));
        assertThat(read)
                .containsExactlyElementsOf(IntStream.rangeClosed(middle + 1, middle + 10)
                        .mapToObj(column -> (Point2D) new Point2D.Double(column + 0.5, HEIGHT / 2 + 0.5))
                        .toList());
        press("shift DOWN");
        press("UP");
        Point2D.Double there = new Point2D.Double(middle + 10.5, HEIGHT / 2 + 9.5);
        assertThat(lastRead()).isEqualTo(there);
        press("ENTER");
        assertThat(clicked).containsExactly(there);
    }

    @Test
    void whatTheKeysPointAtIsReadAgainInAnotherPicture() {
        press("LEFT");
        read.clear();
        canvas.show(pictures(Studio.DEFAULT));
        assertThat(read).containsExactly(new Point2D.Double(WIDTH / 2 - 0.5, HEIGHT / 2 + 0.5));
    }

    @Test
    void theMouseTakesOverFromTheKeys() {
        press("LEFT");
        mouse(MouseEvent.MOUSE_MOVED, new Point(10, 20));
        // a point of the canvas covers two by two pixels, and its middle lies between them
        assertThat(lastRead()).isEqualTo(new Point2D.Double(21.5, 41.5));
        press("ENTER");
        assertThat(clicked).as("no ring").isEmpty();
        mouse(MouseEvent.MOUSE_PRESSED, new Point(10, 20));
        mouse(MouseEvent.MOUSE_RELEASED, new Point(10, 20));
        assertThat(clicked).containsExactly(lastRead());
        mouse(MouseEvent.MOUSE_EXITED, new Point(-1, -1));
        assertThat(lastRead()).isNull();
    }

    @ParameterizedTest
    @CsvSource({"0, 0, true", "3, -2, true", "0, 6, false", "60, 20, false"})
    void aPressThatMovesIsNoClick(int right, int down, boolean isClick) {
        Point from = new Point(30, 40);
        Point to = new Point(from.x + right, from.y + down);
        mouse(MouseEvent.MOUSE_PRESSED, from);
        mouse(MouseEvent.MOUSE_DRAGGED, to);
        mouse(MouseEvent.MOUSE_RELEASED, to);
        assertThat(clicked).hasSize(isClick ? 1 : 0);
    }

    @Test
    void aPressThatMovesAwayAndBackIsNoClick() {
        Point from = new Point(30, 40);
        mouse(MouseEvent.MOUSE_PRESSED, from);
        mouse(MouseEvent.MOUSE_DRAGGED, new Point(70, 40));
        mouse(MouseEvent.MOUSE_DRAGGED, from);
        mouse(MouseEvent.MOUSE_RELEASED, from);
        assertThat(clicked).isEmpty();
    }

    @Test
    void aScreenOfOtherPixelsIsToldOf() {
        sizes.clear();
        PropertyChangeEvent moved = new PropertyChangeEvent(canvas, "graphicsConfiguration", null, null);
        for (PropertyChangeListener listener : canvas.getPropertyChangeListeners("graphicsConfiguration")) {
            listener.propertyChange(moved);
        }
        assertThat(sizes).containsExactly(new Room(new Dimension(WIDTH / 2, HEIGHT / 2), false, false));
    }
}
