package tompkins.ui.picture;

import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.GraphicsConfiguration;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.JPanel;
import javax.swing.UIManager;
import tompkins.studio.Studio;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.Texts;

/**
 * Shows the photograph as large as the window allows, alone or beside another one, and knows what lies under the mouse.
 */
@SuppressWarnings("serial") // never written to a stream
public final class PictureCanvas extends JPanel {

    /** Told what the mouse points at; places in pixels of the photograph. */
    public interface Mouse {

        /**
         * The mouse is over a place of the picture that is seen there; both are null if it has left the pictures.
         *
         * @param rests whether it has not moved, but the picture under it is another one, or lies elsewhere
         */
        void over(Point2D place, Picture seen, boolean rests);

        /** A menu is asked for at a place of the picture that is seen there, which is a point of the canvas. */
        void asksForMenu(Point2D place, Picture seen, Point at);
    }

    /** The distance between two pictures side by side. */
    private static final int GAP = 8;

    private final Consumer<Room> resized;
    private ScreenPicture shown = ScreenPicture.EMPTY;
    private Comparison comparison = Comparison.NONE;
    private String otherName = "";
    private boolean otherAlone;
    private double divider = 0.5;
    private final CanvasZoom zoom = new CanvasZoom(this);
    private Point2D pin;
    private transient PictureTool tool;
    private transient Consumer<Point2D> centring = place -> {};

    /** What to write into a picture of a studio; null if nothing. */
    private Function<Studio, String> captions;

    /** Where the mouse is; null if that is elsewhere. */
    private Point mouseAt;

    private final KeyPointer keyPointer;
    private final transient CanvasMouse hand;
    private final transient List<Overlay> overlays = new ArrayList<>();

    private Mouse mouse;

    /** A canvas that tells of the room that it has for each picture. */
    public PictureCanvas(Consumer<Room> resized) {
        this.resized = resized;
        setName("picture");
        setFocusable(true);
        setPreferredSize(new Dimension(960, 720));
        setMinimumSize(new Dimension(240, 180));
        getAccessibleContext().setAccessibleName(Texts.get("picture.name"));
        getAccessibleContext().setAccessibleDescription(Texts.get("picture.tip"));
        // another screen may have other pixels
        addPropertyChangeListener("graphicsConfiguration", change -> tellSize());
        keyPointer = new KeyPointer(this);
        hand = new CanvasMouse(this);
    }

    @Override
    public void setBounds(int x, int y, int width, int height) {
        super.setBounds(x, y, width, height);
        tellSize();
    }

    /** Tells a listener what the mouse does on the picture. */
    public void setMouse(Mouse listener) {
        mouse = listener;
    }

    /** Shows pictures at once, before anything else is done about a new picture. */
    public void show(ScreenPicture pictures) {
        Picture before = pointedPicture();
        shown = pictures;
        if (comparison == Comparison.BESIDE) {
            // one of other proportions may have its room elsewhere
            tellSize();
        }
        paintImmediately(0, 0, getWidth(), getHeight());
        Picture now = pointedPicture();
        if (before != null && now != null && before.plan() != now.plan()) {
            tellAgain();
        }
    }

    /** The place of the picture that the keys or else the mouse points at; null if there is none. */
    public Point2D pointedPlace() {
        Point2D keys = keyPointer.place();
        return keys != null || mouseAt == null ? keys : pictureAt(mouseAt);
    }

    private Picture pointedPicture() {
        Point2D keys = keyPointer.place();
        return keys != null ? arrangement().seenAt(keys) : mouseAt == null ? null : shownAt(mouseAt);
    }

    /** Tells what the keys or the mouse points at. */
    void tellPointed() {
        mouse.over(pointedPlace(), pointedPicture(), false);
    }

    /** Tells what the keys or the mouse points at now, if they point at the pictures. */
    private void tellAgain() {
        if (keyPointer.place() != null || mouseAt != null) {
            mouse.over(pointedPlace(), pointedPicture(), true);
        }
    }

    /** Clicks at what the keys or the mouse points at, if there is a picture. */
    void click() {
        Point2D place = pointedPlace();
        if (place != null) {
            tool.click(place, pointedPicture());
        }
    }

    /** Clicks there for the second time at once. */
    void clickAgain() {
        Point2D place = pointedPlace();
        if (place != null && !tool.clickAgain(place, pointedPicture())) {
            centring.accept(place);
        }
    }

    /** Asks for a menu where the keys or the mouse point, or else in the middle, if there is a picture. */
    void askForMenu() {
        if (pointedPlace() == null) {
            keyPointer.pointAtMiddle();
        }
        Point2D place = pointedPlace();
        if (place != null) {
            Rectangle bounds = pictureBounds();
            double x = place.getX() / shown.now().ownWidth();
            double y = place.getY() / shown.now().ownHeight();
            Point keys = new Point((int) (bounds.x + x * bounds.width), (int) (bounds.y + y * bounds.height));
            mouse.asksForMenu(place, pointedPicture(), keyPointer.place() != null ? keys : mouseAt);
        }
    }

    /** What is on the screen. */
    public ScreenPicture shown() {
        return shown;
    }

    /** How to show the other picture, and what to call it. */
    public void setComparison(Comparison how, String nameOfOther) {
        comparison = how;
        otherName = nameOfOther;
        tellSize();
        tellAgain();
        repaint();
    }

    /** Whether the other picture is shown alone for a while. */
    public void setOtherAlone(boolean alone) {
        otherAlone = alone;
        tellSize();
        tellAgain();
        repaint();
    }

    /** Moves the divider, from 0 at the left edge to 1. */
    void setDivider(double place) {
        divider = Math.max(0, Math.min(1, place));
        tellAgain();
        repaint();
    }

    /** Where the divider is, from 0 at the left edge to 1. */
    public double divider() {
        return divider;
    }

    /** Marks a place of the picture, or none if it is null. */
    public void setPin(Point2D place) {
        pin = place;
        repaint();
    }

    /** What to write into the picture of a studio, and into that of another one; null if nothing. */
    public void setCaptions(Function<Studio, String> texts) {
        captions = texts;
        repaint();
    }

    /** Takes a tool into the hand. */
    public void setTool(PictureTool taken) {
        tool = taken;
        setCursor(Cursor.getPredefinedCursor(tool.cursor()));
    }

    /** What is in the hand. */
    PictureTool tool() {
        return tool;
    }

    /** Lets a double click turn the camera to a place of the photograph. */
    public void setCentring(Consumer<Point2D> turn) {
        centring = turn;
    }

    /** Where the picture lies in this component. */
    public Rectangle pictureBounds() {
        return PicturePainter.inUnits(arrangement().bounds(), scale());
    }

    PictureArrangement arrangement() {
        return arrangement(otherAlone);
    }

    private PictureArrangement arrangement(boolean alone) {
        double scale = scale();
        Dimension size = new Dimension(inPixels(getWidth(), scale), inPixels(getHeight(), scale));
        return new PictureArrangement(shown, comparison, alone, divider, zoom.now(), size, inPixels(GAP, scale));
    }

    private PicturePainter painter() {
        return new PicturePainter(arrangement(), otherName, captions, Look.captions(), scale());
    }

    /** Pixels of the screen for each unit of the canvas. */
    double scale() {
        GraphicsConfiguration screen = getGraphicsConfiguration();
        return screen == null ? 1 : screen.getDefaultTransform().getScaleX();
    }

    private static int inPixels(double length, double scale) {
        return Math.max(1, (int) Math.round(length * scale));
    }

    private Point inPixels(Point point) {
        double scale = scale();
        return new Point((int) ((point.x + 0.5) * scale), (int) ((point.y + 0.5) * scale));
    }

    /** How the picture is enlarged, and what enlarges it. */
    public CanvasZoom zoom() {
        return zoom;
    }

    /** The zoom has changed. */
    void zoomed() {
        tellSize();
        tellAgain();
        repaint();
    }

    private void tellSize() {
        if (getWidth() > 0 && getHeight() > 0) {
            // a picture that is shown alone for a moment keeps its pixels
            resized.accept(arrangement(false).space());
        }
    }

    /** Whether two pictures are seen. */
    public boolean showsTwo() {
        return arrangement().showsTwo();
    }

    boolean splits() {
        return arrangement().splits();
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.setColor(UIManager.getColor("Tompkins.canvas"));
        g.fillRect(0, 0, getWidth(), getHeight());
        if (shown.nowImage() != null) {
            PicturePainter painter = painter();
            painter.paint(g);
            paintOverlays(g, painter.free(g));
            if (pin != null) {
                painter.paintPin(g, pin);
            }
            if (keyPointer.place() != null) {
                painter.paintRing(g, keyPointer.place());
            }
        }
        g.dispose();
    }

    private void paintOverlays(Graphics2D g, Rectangle free) {
        PictureArrangement seen = arrangement();
        for (Overlay overlay : overlays) {
            if (overlay.isOfAllPictures()) {
                seen.panes().forEach(pane -> paint(g, overlay, pane, free));
            } else {
                paint(g, overlay, seen.studioPane(), free);
            }
        }
    }

    private void paint(Graphics2D g, Overlay overlay, PictureArrangement.Pane pane, Rectangle free) {
        Rectangle bounds = PicturePainter.inUnits(pane.bounds(), scale());
        Rectangle visible = bounds.intersection(PicturePainter.inUnits(pane.part(), scale()));
        Graphics2D clipped = (Graphics2D) g.create();
        clipped.clip(visible);
        overlay.paint(clipped, pane.picture(), bounds, visible, free);
        clipped.dispose();
    }

    /** Paints something over the pictures that is not part of them. */
    public void addOverlay(Overlay overlay) {
        overlays.add(overlay);
    }

    /**
     * Where the picture lies that is seen at a point of this component, which may be the other one; null if there is
     * none.
     */
    public Rectangle boundsAt(Point point) {
        PictureArrangement.Pane pane = arrangement().paneAt(inPixels(point));
        return pane == null ? null : PicturePainter.inUnits(pane.bounds(), scale());
    }

    /** Where the divider is on this component; a point far away if there is none. */
    int dividerX() {
        return splits() ? (int) Math.round(arrangement().dividerX() / scale()) : Integer.MIN_VALUE / 2;
    }

    /** Where the mouse is; null if that is elsewhere. */
    Point mouseAt() {
        return mouseAt;
    }

    /** The mouse now points at a place, or nowhere if it is null; the keys no longer point. */
    void pointMouse(Point point) {
        if (point != null) {
            keyPointer.forget();
        }
        mouseAt = point;
    }

    /** Shows the picture of another scene: as large as it fits, and nothing in it is pointed at by keys. */
    public void beginScene() {
        zoom.fit();
        keyPointer.forget();
    }

    /** What the mouse does. */
    public CanvasMouse hand() {
        return hand;
    }

    /** The place of the picture, or of the one beside it, at a point of this component; null if there is none. */
    public Point2D pictureAt(Point point) {
        return arrangement().pictureAt(inPixels(point));
    }

    /** The picture that is seen at a point, beyond the divider the other one; null if there is none. */
    public Picture shownAt(Point point) {
        PictureArrangement.Pane pane = arrangement().paneAt(inPixels(point));
        return pane == null ? null : pane.picture();
    }
}
