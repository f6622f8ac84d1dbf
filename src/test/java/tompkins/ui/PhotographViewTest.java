package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.MouseEvent;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.light.ColourLaw;
import tompkins.render.Quality;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studios;
import tompkins.ui.compare.ComparePanel;
import tompkins.ui.compare.Compared;
import tompkins.ui.editor.ChooseTool;
import tompkins.ui.measure.MeasureTool;
import tompkins.ui.model.StudioModel;
import tompkins.ui.photograph.PhotographView;
import tompkins.ui.picture.Comparison;
import tompkins.ui.picture.Picture;
import tompkins.ui.picture.PictureCanvas;
import tompkins.ui.picture.ScreenPicture;
import tompkins.ui.ray.PixelReading;
import tompkins.ui.widget.Texts;

@LightLook
@Timeout(120)
class PhotographViewTest {

    private final StudioModel model =
            new StudioModel(Studios.lattice().withSettings(Studios.sphere().settings()), null);

    private final List<PixelReading> read = new ArrayList<>();
    private final List<PixelReading> pinned = new ArrayList<>();
    private final List<String> told = new ArrayList<>();

    @AutoClose
    private final PhotographView view =
            WindowDriver.onEventThread(() -> new PhotographView(model, new SilentListener() {
                @Override
                public void read(PixelReading reading, boolean rests) {
                    read.add(reading);
                }

                @Override
                public void pinned(PixelReading reading, String picture) {
                    pinned.add(reading);
                }

                @Override
                public void hints(String click) {
                    told.add(click);
                }
            }));

    @BeforeEach
    void size() {
        WindowDriver.onEventThread(() -> view.canvas().setSize(64, 48));
    }

    @Test
    void bothPicturesOfOneStudioAreEquallyGood() {
        Quality.TargetError fine = new Quality.TargetError(0.002);
        WindowDriver.onEventThread(() -> {
            model.set(model.studio().withVelocity(Velocity.of(0, 0, 0)));
            compareWithRest();
        });
        awaitBoth("the pictures of one sample", new Quality.Samples(1));
        WindowDriver.onEventThread(() -> model.set(
                model.studio().withSettings(model.studio().settings().withTargetError(fine.rootMeanSquare()))));
        awaitBoth("the pictures of many samples", fine);
        BufferedImage difference = view.canvas().shown().difference();
        int[] levels = difference.getRGB(0, 0, 64, 48, null, 0, 64);
        assertThat(IntStream.of(levels).filter(level -> level != 0xff000000)).isEmpty();
    }

    @Test
    void aKeptPictureIsCalledByItsSpeedAndItsColours() {
        WindowDriver.onEventThread(() ->
                model.set(model.studio().withVelocity(Velocity.of(0, 0, 0.6)).withColours(ColourLaw.SEARCHLIGHT)));
        view.render();
        WindowDriver.await(
                "the picture",
                () -> view.canvas().shown().now() != null
                        && view.canvas().shown().now().studio().equals(model.studio()));
        assertThat(WindowDriver.onEventThread(view::keepPicture))
                .endsWith("\u03b2 = 0.6, \u03b3 = 1.25, Searchlight effect");
    }

    @Test
    void savingTakesNoOtherPicture() {
        WindowDriver.onEventThread(() -> model.set(model.studio().withVelocity(Velocity.of(0, 0, 0.3))));
        WindowDriver.await("the picture", () -> !view.controller().isBusy());
        WindowDriver.onEventThread(() -> {
            model.saved(model.studio(), Path.of("saved.json"));
            assertThat(view.controller().isBusy()).isFalse();
            // a quick picture may be complete before the next line
            model.set(Studios.slow());
            assertThat(view.controller().isBusy()).isTrue();
        });
    }

    @Test
    void aStoppedOtherPictureIsMadeAgain() throws InterruptedException {
        WindowDriver.onEventThread(() -> {
            model.set(Studios.slow());
            compareWithRest();
        });
        WindowDriver.await("the other picture", () -> other() != null);
        WindowDriver.onEventThread(view::stop);
        Thread.sleep(300);
        Picture stopped = other();
        WindowDriver.onEventThread(() -> model.set(Studios.slow().withVelocity(Velocity.of(0, 0, 0.5))));
        WindowDriver.await("the other picture again", () -> other() != stopped);
        assertThat(other().studio()).isEqualTo(stopped.studio());
    }

    @Test
    void whatIsReadAfterTheMouseHasLeftIsNotShown() {
        PictureCanvas canvas = canvasWithPicture();
        Components.mouse(canvas, MouseEvent.MOUSE_MOVED, 32, 24);
        WindowDriver.await("the reading", () -> !read.isEmpty());
        WindowDriver.onEventThread(() -> {
            Components.mouse(canvas, MouseEvent.MOUSE_MOVED, 32, 24);
            // the answer is there, and waits until this is done
            sleep(200);
            Components.mouse(canvas, MouseEvent.MOUSE_EXITED, 32, 24);
        });
        assertThat(WindowDriver.onEventThread(() -> read.get(read.size() - 1))).isNull();
    }

    /** A double click brings a place into the middle: the pin of its first half goes, and the one before stays. */
    @Test
    void aDoubleClickPinsNothing() {
        PictureCanvas canvas = canvasWithPicture();
        WindowDriver.onEventThread(() -> doubleClick(canvas, 32, 24));
        assertThat(pinned).endsWith((PixelReading) null);
        WindowDriver.onEventThread(() -> {
            view.setPin(new Point2D.Double(10.5, 12.5));
            doubleClick(canvas, 32, 24);
        });
        WindowDriver.await("the reading of the pin before", () -> {
            PixelReading last = pinned.get(pinned.size() - 1);
            return last != null && last.column() == 10 && last.row() == 12;
        });
    }

    private PictureCanvas canvasWithPicture() {
        WindowDriver.onEventThread(view::render);
        WindowDriver.await("a picture", () -> view.canvas().shown().now() != null);
        return view.canvas();
    }

    /** Measuring comes before choosing; each gives the click back when it ends. */
    @Test
    void whatAClickDoesIsTold() {
        AtomicBoolean editing = new AtomicBoolean();
        MeasureTool measure = new MeasureTool(view, text -> {});
        new ChooseTool(model, view, editing::get, part -> {});
        WindowDriver.onEventThread(() -> {
            measure.component();
            measure.setOn(true);
            measure.setOn(false);
            editing.set(true);
            view.tellTool();
            measure.setOn(true);
            measure.setOn(false);
        });
        String measures = Texts.get("status.idle.MEASURE");
        String chooses = Texts.get("status.idle.CHOOSE");
        assertThat(told).containsExactly(measures, "", chooses, measures, chooses);
    }

    private static void doubleClick(PictureCanvas canvas, int x, int y) {
        for (int count = 1; count <= 2; count++) {
            for (int event : new int[] {MouseEvent.MOUSE_PRESSED, MouseEvent.MOUSE_RELEASED}) {
                canvas.dispatchEvent(new MouseEvent(canvas, event, 0, 0, x, y, count, false, MouseEvent.BUTTON1));
            }
        }
    }

    private static void sleep(int milliseconds) {
        try {
            Thread.sleep(milliseconds);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Eight pixels lie between the two. */
    @Test
    void sideBySideBothPicturesAreWholeAndRead() {
        WindowDriver.onEventThread(() -> {
            model.set(Studios.sphere().withVelocity(Velocity.of(0, 0, 0.5)));
            view.canvas().setSize(2 * 64 + 8, 48);
            compareWithRest();
            view.canvas().setComparison(Comparison.BESIDE, "at rest");
        });
        awaitBoth("both pictures", new Quality.Samples(1));
        PictureCanvas canvas = view.canvas();
        WindowDriver.onEventThread(() -> {
            assertThat(canvas.pictureBounds()).isEqualTo(new Rectangle(0, 0, 64, 48));
            assertThat(canvas.shownAt(new Point(10, 20)))
                    .isSameAs(canvas.shown().now());
            assertThat(canvas.pictureAt(new Point(10, 20))).isEqualTo(new Point2D.Double(10.5, 20.5));
            assertThat(canvas.shownAt(new Point(72 + 10, 20)))
                    .isSameAs(canvas.shown().other());
            assertThat(canvas.pictureAt(new Point(72 + 10, 20))).isEqualTo(new Point2D.Double(10.5, 20.5));
            assertThat(canvas.pictureAt(new Point(68, 20))).isNull();
            assertThat(canvas.shownAt(new Point(68, 20))).isNull();
        });
    }

    /** A picture of 4:3, of which at least half is seen, in the larger of two arrangements; two have a gap of 8. */
    @ParameterizedTest
    @CsvSource({
        // beside each other in 48 x 64: as high as the room
        "104, 64, -18, 0, 85, 64, 56, 0",
        // one above the other in 64 x 30: as wide as the room
        "64, 68, 0, -9, 64, 48, 0, 38",
        // one above the other in 48 x 36, which it fits; in 20 x 80 it would be cut by more than half
        "48, 80, 0, 0, 48, 36, 0, 44"
    })
    void sideBySidePicturesUseTheRoom(int width, int height, int x, int y, int wide, int high, int right, int down) {
        WindowDriver.onEventThread(() -> {
            model.set(Studios.sphere().withVelocity(Velocity.of(0, 0, 0.5)));
            view.canvas().setSize(width, height);
            compareWithRest();
            view.canvas().setComparison(Comparison.BESIDE, "at rest");
        });
        WindowDriver.await("both pictures", () -> view.size().equals(new Dimension(wide, high)) && isComplete(other()));
        PictureCanvas canvas = view.canvas();
        WindowDriver.onEventThread(() -> {
            assertThat(canvas.pictureBounds()).isEqualTo(new Rectangle(x, y, wide, high));
            assertThat(canvas.boundsAt(new Point(right + 5, down + 5)))
                    .isEqualTo(new Rectangle(right + x, down + y, wide, high));
            assertThat(canvas.shownAt(new Point(right + 5, down + 5))).isSameAs(other());
        });
    }

    private static boolean isComplete(Picture picture) {
        return picture != null && picture.complete();
    }

    private Picture other() {
        return view.canvas().shown().other();
    }

    private void compareWithRest() {
        view.compare(new Compared(ComparePanel.Other.AT_REST, null, Comparison.DIFFERENCE, "at rest"));
    }

    private void awaitBoth(String what, Quality quality) {
        WindowDriver.await(what, () -> {
            ScreenPicture shown = view.canvas().shown();
            return isComplete(shown.now(), quality) && isComplete(shown.other(), quality);
        });
    }

    private static boolean isComplete(Picture picture, Quality quality) {
        return picture != null && picture.complete() && picture.quality().equals(quality);
    }
}
