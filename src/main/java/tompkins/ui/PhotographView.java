package tompkins.ui;

import java.awt.Dimension;
import java.awt.geom.Point2D;
import java.util.Objects;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import java.util.function.DoublePredicate;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;
import tompkins.camera.Aim.PicturePlace;
import tompkins.camera.Camera;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;
import tompkins.ui.model.StudioModel;
import tompkins.ui.panel.Compared;
import tompkins.ui.picture.Comparison;
import tompkins.ui.picture.Pace;
import tompkins.ui.picture.Picture;
import tompkins.ui.picture.PictureCanvas;
import tompkins.ui.picture.PixelProbe;
import tompkins.ui.picture.RenderController;
import tompkins.ui.picture.Room;
import tompkins.ui.picture.ScreenPicture;
import tompkins.ui.picture.ScreenPictures;
import tompkins.ui.widget.Messages;
import tompkins.ui.widget.Texts;

/** The photograph of the current studio on its canvas, with what it is compared with, and the probe of its pixels. */
final class PhotographView implements AutoCloseable {

    /** Told what there is to know about the picture on the screen. */
    interface Listener {

        /** Another picture is on the screen. */
        void shown(Picture picture);

        /** A pixel was read; null if the mouse has left the picture. */
        void read(PixelProbe.Reading reading);

        /**
         * The pinned pixel was read; null if none is pinned.
         *
         * @param picture what the picture is called in which it is pinned, or null if it is the studio's
         */
        void pinned(PixelProbe.Reading reading, String picture);

        /** Whether the next click on the picture picks a point, from now on. */
        void picking(boolean picking);

        /** There is no picture of the studio; the message says why. */
        void noPicture(String message);

        /** There is no picture to compare with, or no reading of a pixel; the message says why. */
        void failed(String message);
    }

    private final StudioModel model;
    private final Listener listener;
    private final PictureCanvas canvas;
    private final PictureNotice notice;
    private final ScreenPictures screen;
    private final RenderController controller;
    private final OtherPicture other;
    private final Supplier<Pace> pace;
    private final PixelProbe hover = new PixelProbe(this::fail);
    private final PixelProbe pinned = new PixelProbe(this::fail);
    private final PixelProbe picked = new PixelProbe(this::fail);
    private Studio rendered;

    /** The room for each picture; null while nobody knows it. */
    private Room room;

    private Point2D pin;
    private boolean pinnedInOther;
    private RenderPlan pinnedPlan;
    private String pinnedName;
    private Picking picking;

    /** Told of clicks while somebody measures; null otherwise. */
    private Consumer<Point2D> measuring;

    /** The photograph of a model; {@code pace} says how soon a picture of a change has to come. */
    PhotographView(StudioModel model, Listener listener, Supplier<Pace> pace) {
        this.model = model;
        this.listener = listener;
        this.pace = pace;
        screen = new ScreenPictures(this::show, this::fail);
        canvas = new PictureCanvas(this::fit);
        canvas.setMouse(new ProbeMouse());
        notice = new PictureNotice(model, canvas);
        controller = new RenderController(
                screen::setNow, error -> SwingUtilities.invokeLater(() -> listener.noPicture(Messages.of(error))));
        other = new OtherPicture(model, screen, pace, this::sizeOf, this::fail);
        model.addLiveListener(this::renderChange);
    }

    PictureCanvas canvas() {
        return canvas;
    }

    RenderController controller() {
        return controller;
    }

    /** Tells what went wrong; called by any thread. */
    void fail(Throwable error) {
        SwingUtilities.invokeLater(() -> listener.failed(Messages.of(error)));
    }

    /** A studio that was only saved keeps its picture. */
    private void renderChange() {
        if (!model.studio().equals(rendered)) {
            render();
        }
    }

    /** Makes the picture of the current studio. */
    void render() {
        rendered = model.studio();
        controller.show(rendered, sizeOf(rendered), pace.get());
        other.render();
    }

    /** Pictures are taken in the size in which they are shown; in their own as long as nobody knows that. */
    private Dimension sizeOf(Studio studio) {
        RenderSettings own = studio.settings();
        return room == null ? new Dimension(own.width(), own.height()) : room.sizeOf(own);
    }

    /** The size in which the picture of the current studio is taken. */
    Dimension size() {
        return sizeOf(model.studio());
    }

    private void fit(Room newRoom) {
        Dimension before = size();
        room = newRoom;
        screen.setRoom(room);
        // before the first picture there is nothing to take again
        if (rendered != null && !size().equals(before)) {
            render();
        }
    }

    /** Ends the work on all pictures; what is there stays until the next change. */
    void stop() {
        controller.stop();
        other.stop();
    }

    private void show(ScreenPicture pictures) {
        canvas.show(pictures);
        notice.show(pictures.now());
        listener.shown(pictures.now());
        if (pin != null && !pictures.now().holds(pin)) {
            setPin(null);
        } else if (pin != null
                && (pinnedPicture().plan() != pinnedPlan || !Objects.equals(nameOf(pinnedPicture()), pinnedName))) {
            readPin();
        }
    }

    /** What the photograph is compared with. */
    OtherPicture other() {
        return other;
    }

    /** Compares with another picture from now on. */
    void compare(Compared compared) {
        other.compare(compared);
        canvas.setComparison(compared.view(), compared.name());
        screen.setDifference(compared.view() == Comparison.DIFFERENCE);
        other.render();
        if (pin != null) {
            readPin();
        }
    }

    /** Keeps the picture that is on the screen, to compare others with it; says what to call it. */
    String keepPicture() {
        Picture picture = canvas.shown().now();
        other.keep(picture);
        Studio kept = picture == null ? model.studio() : picture.studio();
        return Texts.get("compare.kept", kept.shortTitle(), Captions.motion(kept));
    }

    /** Marks a place of the picture and tells the life of its ray; of no place if it is null. */
    void setPin(Point2D place) {
        setPin(place, false);
    }

    private void setPin(Point2D place, boolean inOther) {
        pin = place;
        pinnedInOther = inOther;
        canvas.setPin(place);
        readPin();
    }

    private Picture pinnedPicture() {
        ScreenPicture shown = canvas.shown();
        return pinnedInOther && shown.otherImage() != null ? shown.other() : shown.now();
    }

    private void readPin() {
        Picture picture = pinnedPicture();
        if (pin == null || picture == null) {
            // it may hold a large scene
            pinnedPlan = null;
            listener.pinned(null, null);
            return;
        }
        pinnedPlan = picture.plan();
        String name = nameOf(picture);
        pinnedName = name;
        pinned.ask(picture, placeIn(picture, pin), reading -> listener.pinned(pin == null ? null : reading, name));
    }

    /** What a picture is called where two are seen; null where the studio's is seen alone. */
    private String nameOf(Picture picture) {
        if (picture != canvas.shown().now()) {
            return other.compared().name();
        }
        return canvas.showsTwo() ? Texts.get("compare.now") : null;
    }

    /** The same place in another picture: a kept one may have another size. */
    private Point2D placeIn(Picture picture, Point2D place) {
        double scale = (double) picture.studio().settings().width()
                / canvas.shown().now().studio().settings().width();
        return new Point2D.Double(scale * place.getX(), scale * place.getY());
    }

    /**
     * Lets clicks on the picture give the distance of what is there, until one is taken.
     *
     * @param taker takes a distance, or none: of nothing it is NaN
     * @param ended called when a distance was taken, or the picking was cancelled
     */
    void startPicking(DoublePredicate taker, Runnable ended) {
        picking = new Picking(taker, ended);
        canvas.setPicking(true);
        listener.picking(true);
    }

    /** Lets clicks on the picture pin pixels again. */
    void stopPicking() {
        picking = null;
        canvas.setPicking(false);
        listener.picking(false);
    }

    /** Lets clicks on the picture tell places, until it is called with null. */
    void setMeasuring(Consumer<Point2D> taker) {
        measuring = taker;
        canvas.setMeasuring(taker != null);
    }

    /** Asks how far away what is seen at a place is: as far as what is in focus where nothing is. */
    void askDistance(PicturePlace place, DoubleConsumer answer) {
        Picture picture = canvas.shown().now();
        Camera camera = picture.studio().camera();
        double focus = Math.abs(camera.focusDistance());
        double usual = Double.isFinite(focus) && focus > 0 ? focus : 1;
        Point2D point = new Point2D.Double(place.x(), place.y());
        picked.ask(
                picture,
                point,
                reading -> answer.accept(
                        reading.inCamera() == null
                                ? usual
                                : reading.inCamera().position().distance(camera.position())));
    }

    /** Ends the picking; false if nothing was to be picked. */
    boolean endPicking() {
        Picking ending = picking;
        stopPicking();
        if (ending != null) {
            ending.ended.run();
        }
        return ending != null;
    }

    private record Picking(DoublePredicate taker, Runnable ended) {}

    private final class ProbeMouse implements PictureCanvas.Mouse {

        private boolean isOver;

        /** What was pinned before the last click. */
        private Point2D pinBefore;

        private boolean pinBeforeInOther;

        @Override
        public void over(Point2D place, Picture seen) {
            isOver = seen != null;
            if (isOver) {
                hover.ask(seen, placeIn(seen, place), this::read);
            } else {
                listener.read(null);
            }
        }

        private void read(PixelProbe.Reading reading) {
            // the mouse may have left while the ray was followed
            if (isOver) {
                listener.read(reading);
            }
        }

        @Override
        public void clicked(Point2D place, Picture seen) {
            if (picking != null) {
                Picking asking = picking;
                Picture picture = canvas.shown().now();
                picked.ask(picture, place, reading -> {
                    // it may have been cancelled meanwhile
                    if (picking == asking && asking.taker.test(PixelProbe.depth(picture.plan(), reading))) {
                        endPicking();
                    }
                });
            } else if (measuring != null) {
                measuring.accept(place);
            } else {
                pinBefore = pin;
                pinBeforeInOther = pinnedInOther;
                setPin(place, seen != canvas.shown().now());
            }
        }

        @Override
        public void clickedTwice() {
            if (picking == null) {
                setPin(pinBefore, pinBeforeInOther);
            }
        }
    }

    @Override
    public void close() {
        controller.close();
        other.close();
        screen.close();
        hover.close();
        pinned.close();
        picked.close();
    }
}
