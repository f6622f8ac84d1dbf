package tompkins.ui.photograph;

import java.awt.Dimension;
import java.awt.Point;
import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;
import tompkins.camera.Aim.PicturePosition;
import tompkins.camera.Camera;
import tompkins.camera.FocusDistance;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;
import tompkins.trace.SampleHistory;
import tompkins.ui.compare.Compared;
import tompkins.ui.compare.ComparedPicture;
import tompkins.ui.model.Pace;
import tompkins.ui.model.StudioModel;
import tompkins.ui.picture.Asker;
import tompkins.ui.picture.Comparison;
import tompkins.ui.picture.Picture;
import tompkins.ui.picture.PictureCanvas;
import tompkins.ui.picture.PictureTool;
import tompkins.ui.picture.RenderController;
import tompkins.ui.picture.Room;
import tompkins.ui.picture.ScreenPicture;
import tompkins.ui.picture.ScreenPictures;
import tompkins.ui.ray.PixelPin;
import tompkins.ui.ray.PixelReading;
import tompkins.ui.widget.Messages;
import tompkins.ui.widget.Texts;

/** The photograph of the current studio on its canvas, with what it is compared with, and the probe of its pixels. */
public final class PhotographView implements AutoCloseable {

    /** Told what there is to know about the picture on the screen. */
    public interface Listener {

        /** Another picture is on the screen. */
        void shown(Picture picture);

        /**
         * A pixel was read; null if the mouse has left the picture.
         *
         * @param rests whether the mouse has not moved, but the picture under it has changed
         */
        void read(PixelReading reading, boolean rests);

        /**
         * The pinned pixel was read; null if none is pinned.
         *
         * @param picture name of the picture in which it is pinned, or null if it is the studio's
         */
        void pinned(PixelReading reading, String picture);

        /** What a click in the picture does from now on; empty if there may be something better to say. */
        void hints(String click);

        /** There is no picture of the studio; the message says why. */
        void noPicture(String message);

        /** There is no picture to compare with, or no reading of a pixel; the message says why. */
        void failed(String message);
    }

    /** Offers actions on what is seen. */
    public interface Menu {

        /** Shows the menu for a place of a picture, at a point of the canvas. */
        void show(PixelReading seen, Picture picture, Point2D place, Point at);
    }

    private final StudioModel model;
    private final Listener listener;
    private final PictureCanvas canvas;
    private final PictureNotice notice;
    private final ScreenPictures screen;
    private final RenderController controller;
    private final ComparedPicture compared;
    private final Asker asker = new Asker("tompkins-asker", this::fail);
    private final PixelPin pin;

    /** The first that is wanted is in the hand, or else the pin. */
    private final List<PictureTool> tools = new ArrayList<>();

    private Studio rendered;

    /** The room for each picture; null while it is unknown. */
    private Room room;

    private Menu menu;

    /** The photograph of a model. */
    public PhotographView(StudioModel model, Listener listener) {
        this.model = model;
        this.listener = listener;
        screen = new ScreenPictures(this::show, this::fail);
        canvas = new PictureCanvas(this::fit);
        canvas.setMouse(new ProbeMouse());
        notice = new PictureNotice(model, canvas);
        controller = new RenderController(
                screen::setNow, error -> SwingUtilities.invokeLater(() -> listener.noPicture(Messages.of(error))));
        compared = new ComparedPicture(model, screen, this::sizeOf, this::fail);
        pin = new PixelPin(canvas, this::nameOf, listener::pinned, asker);
        canvas.setTool(pin);
        model.addLiveListener(this::renderChange);
        model.addOpenListener(this::beginScene);
    }

    /** What shows the picture. */
    public PictureCanvas canvas() {
        return canvas;
    }

    /** What makes the picture. */
    public RenderController controller() {
        return controller;
    }

    /** Tells what went wrong; called by any thread. */
    public void fail(Throwable error) {
        SwingUtilities.invokeLater(() -> listener.failed(Messages.of(error)));
    }

    /** A studio that was only saved keeps its picture. */
    private void renderChange(Pace pace) {
        if (!model.studio().equals(rendered)) {
            render(pace);
        }
    }

    /** The pin of the scene before goes, and the picture is as large as it fits. */
    private void beginScene() {
        setPin(null);
        canvas.beginScene();
    }

    /** Makes the picture of the current studio. */
    public void render() {
        render(Pace.HAND);
    }

    private void render(Pace pace) {
        rendered = model.studio();
        controller.show(rendered, sizeOf(rendered), pace);
        compared.render(pace);
    }

    /** The size for the picture of a studio: that in which it is shown, or its own while that is unknown. */
    private Dimension sizeOf(Studio studio) {
        RenderSettings own = studio.settings();
        return room == null ? new Dimension(own.width(), own.height()) : room.sizeOf(own);
    }

    /** The size in which the picture of the current studio is taken. */
    public Dimension size() {
        return sizeOf(model.studio());
    }

    private void fit(Room newRoom) {
        Dimension before = size();
        room = newRoom;
        screen.setRoom(room);
        // before the first picture there is nothing to render again
        if (rendered != null && !size().equals(before)) {
            render();
        }
    }

    /** Ends the work on all pictures; what is there stays until the next change. */
    public void stop() {
        controller.stop();
        compared.stop();
    }

    private void show(ScreenPicture pictures) {
        canvas.show(pictures);
        notice.show(pictures.now());
        listener.shown(pictures.now());
        pin.follow();
    }

    /** Compares with another picture from now on. */
    public void compare(Compared other) {
        canvas.setComparison(other.view(), other.name());
        screen.setDifference(other.view() == Comparison.DIFFERENCE);
        compared.choose(other);
        pin.readAgain();
    }

    /** Lets a camera at rest be where one on a ride is; the supplier gives null where there is no ride. */
    public void setRideAtRest(Supplier<Studio> atRest) {
        compared.setRideAtRest(atRest);
    }

    /** Keeps the picture that is on the screen, to compare others with it; says what to call it. */
    public String keepPicture() {
        Picture now = canvas.shown().now();
        compared.keep(now);
        Studio kept = now == null ? model.studio() : now.studio();
        return Texts.get("compare.kept", kept.shortTitle(), Captions.motion(kept));
    }

    /** Pins a place of the picture, so that the history of its ray is shown; unpins it if the place is null. */
    public void setPin(Point2D place) {
        pin.set(place, false);
    }

    /** Follows a cone of rays around that of the pinned pixel; the answer comes on the event thread. */
    public void askCone(Consumer<List<SampleHistory>> answer) {
        pin.askCone(answer);
    }

    /** The name of a picture if two are shown; null if the studio's is shown alone. */
    private String nameOf(Picture picture) {
        if (picture != canvas.shown().now()) {
            return compared.name();
        }
        return canvas.showsTwo() ? canvas.shown().nameOfNow() : null;
    }

    /** The picture that is compared with that of the studio; null if none is seen. */
    public Picture otherPicture() {
        ScreenPicture shown = canvas.shown();
        return shown.otherImage() == null ? null : shown.other();
    }

    /** What that picture is called. */
    public String otherName() {
        return compared.name();
    }

    /** Adds a tool, which comes before that which pins, and after those that were added earlier. */
    public void addTool(PictureTool tool) {
        tools.add(tool);
    }

    /** Takes the first tool that is wanted into the hand, and tells what a click does from now on. */
    public void tellTool() {
        PictureTool first =
                tools.stream().filter(PictureTool::isWanted).findFirst().orElse(pin);
        canvas.setTool(first);
        listener.hints(first.hint());
    }

    /** Offers a menu from now on. */
    public void setMenu(Menu offered) {
        menu = offered;
    }

    /** What answers questions about the pictures. */
    public Asker asker() {
        return asker;
    }

    /** Asks for the distance of what is seen at a place; where nothing is, it is that of the focus. */
    public void askDistance(PicturePosition place, DoubleConsumer answer) {
        Picture picture = canvas.shown().now();
        Camera camera = picture.studio().camera();
        double focus = Math.abs(FocusDistance.of(camera));
        double usual = Double.isFinite(focus) && focus > 0 ? focus : 1;
        Point2D point = new Point2D.Double(place.x(), place.y());
        asker.ask(
                DoubleConsumer.class,
                () -> PixelReading.of(picture, point),
                reading -> answer.accept(
                        reading.sighting().hit() == null
                                ? usual
                                : reading.sighting().inCamera().position().distance(camera.position())));
    }

    private final class ProbeMouse implements PictureCanvas.Mouse {

        @Override
        public void over(Point2D place, Picture seen, boolean rests) {
            if (seen == null) {
                asker.drop(this);
                listener.read(null, rests);
            } else {
                Point2D own = canvas.shown().placeIn(seen, place);
                asker.ask(this, () -> PixelReading.of(seen, own), reading -> listener.read(reading, rests));
            }
        }

        @Override
        public void asksForMenu(Point2D place, Picture seen, Point at) {
            Point2D own = canvas.shown().placeIn(seen, place);
            if (menu != null) {
                asker.ask(menu, () -> PixelReading.of(seen, own), reading -> menu.show(reading, seen, own, at));
            }
        }
    }

    @Override
    public void close() {
        controller.close();
        compared.close();
        screen.close();
        asker.close();
    }
}
