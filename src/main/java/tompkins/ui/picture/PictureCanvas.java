package tompkins.ui.picture;

import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.GraphicsConfiguration;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.JPanel;
import javax.swing.UIManager;
import tompkins.image.PictureLabel;
import tompkins.image.PictureLabel.Corner;
import tompkins.studio.Studio;
import tompkins.ui.widget.Texts;

/**
 * Shows the photograph as large as the window allows, alone or beside another one, and knows what lies under the mouse.
 */
@SuppressWarnings("serial") // never written to a stream
public final class PictureCanvas extends JPanel {

    /** Told what the mouse does on the picture; places in pixels of the picture. */
    public interface Mouse {

        /** The mouse is over a place of the picture that is seen there; both are null if it has left the pictures. */
        void over(Point2D place, Picture seen);

        /** The mouse was clicked at a place of the picture that is seen there. */
        void clicked(Point2D place, Picture seen);
    }

    private static final int GRIP = 6;

    /** How far a press may move and be a click: a hand shakes. */
    private static final int STILL = 5;

    private final Consumer<Dimension> resized;
    private ScreenPicture shown = ScreenPicture.EMPTY;
    private Comparison comparison = Comparison.NONE;
    private String otherName = "";
    private boolean otherAlone;
    private double divider = 0.5;
    private boolean draggingDivider;
    private Point2D pin;
    private boolean picking;

    /** What to write into a picture of a studio; null if nothing. */
    private Function<Studio, String> captions;

    /** Where the mouse is; null if that is elsewhere. */
    private Point mouseAt;

    private final KeyPointer keyPointer;

    private Mouse mouse;

    /** A canvas that tells of its size in pixels of the screen. */
    public PictureCanvas(Consumer<Dimension> resized) {
        this.resized = resized;
        setName("picture");
        setFocusable(true);
        setPreferredSize(new Dimension(960, 720));
        setMinimumSize(new Dimension(240, 180));
        getAccessibleContext().setAccessibleName(Texts.get("picture.name"));
        getAccessibleContext().setAccessibleDescription(Texts.get("picture.tip"));
        // another screen may have other pixels
        addPropertyChangeListener("graphicsConfiguration", change -> tellSize());
        MouseAdapter adapter = new CanvasMouse();
        addMouseListener(adapter);
        addMouseMotionListener(adapter);
        keyPointer = new KeyPointer(this);
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

    /** Shows pictures, at once: what else there is to do about a new picture comes after it. */
    public void show(ScreenPicture pictures) {
        Picture before = pointedPicture();
        shown = pictures;
        paintImmediately(0, 0, getWidth(), getHeight());
        Picture now = pointedPicture();
        if (before != null && now != null && before.plan() != now.plan()) {
            tellPointed();
        }
    }

    /** The place of the picture that the keys or else the mouse points at; null if there is none. */
    private Point2D pointedPlace() {
        Point2D keys = keyPointer.place();
        return keys != null || mouseAt == null ? keys : pictureAt(mouseAt);
    }

    private Picture pointedPicture() {
        Point2D keys = keyPointer.place();
        return keys != null ? arrangement().seenAt(keys) : mouseAt == null ? null : shownAt(mouseAt);
    }

    /** Tells what the keys or the mouse points at. */
    void tellPointed() {
        mouse.over(pointedPlace(), pointedPicture());
    }

    /** Tells what is there now, if anything points at the pictures. */
    private void tellAgain() {
        if (keyPointer.place() != null || mouseAt != null) {
            tellPointed();
        }
    }

    /** Clicks at what the keys or the mouse points at, if there is a picture. */
    void click() {
        Point2D place = pointedPlace();
        if (place != null) {
            mouse.clicked(place, pointedPicture());
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

    /** Where the divider is, from 0 at the left edge to 1. */
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

    /** Whether the next click picks a point, which the cursor shows. */
    public void setPicking(boolean pick) {
        picking = pick;
        setCursor(Cursor.getPredefinedCursor(pick ? Cursor.CROSSHAIR_CURSOR : Cursor.DEFAULT_CURSOR));
    }

    /** Where the picture lies in this component. */
    public Rectangle pictureBounds() {
        return arrangement().bounds();
    }

    private PictureArrangement arrangement() {
        return new PictureArrangement(shown, comparison, otherAlone, divider, getSize());
    }

    private void tellSize() {
        if (getWidth() == 0 || getHeight() == 0) {
            return;
        }
        GraphicsConfiguration screen = getGraphicsConfiguration();
        double scale = screen == null ? 1 : screen.getDefaultTransform().getScaleX();
        resized.accept(new Dimension(inPixels(arrangement().room(), scale), inPixels(getHeight(), scale)));
    }

    private static int inPixels(int length, double scale) {
        return Math.max(1, (int) Math.round(length * scale));
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
        g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
        if (shown.nowImage() != null) {
            paintPictures(g);
        }
        g.dispose();
    }

    private void paintPictures(Graphics2D g) {
        PictureArrangement seen = arrangement();
        Rectangle bounds = seen.bounds();
        if (seen.showsDifference()) {
            paint(g, shown.difference(), bounds);
            label(g, Texts.get("compare.differenceLabel", otherName), bounds, Corner.TOP_LEFT);
            caption(g, shown.now(), bounds, Corner.BOTTOM_LEFT);
        } else if (seen.showsOtherAlone()) {
            paint(g, shown.otherImage(), bounds);
            label(g, otherName, bounds, Corner.TOP_LEFT);
            caption(g, shown.other(), bounds, Corner.BOTTOM_LEFT);
        } else if (seen.splits()) {
            paintSplit(g, bounds, seen.dividerX());
        } else {
            paint(g, shown.nowImage(), bounds);
            caption(g, shown.now(), bounds, Corner.BOTTOM_LEFT);
        }
        if (comparison != Comparison.NONE && shown.other() != null && shown.otherImage() == null) {
            label(g, Texts.get("compare.otherShape", otherName), bounds, Corner.TOP_LEFT);
        }
        if (seen.isBeside() && shown.otherImage() != null) {
            paintBeside(g, bounds, seen.otherBounds());
        }
        if (pin != null) {
            paintPin(g, bounds);
        }
        keyPointer.paint(g);
    }

    private void paintBeside(Graphics2D g, Rectangle bounds, Rectangle there) {
        paint(g, shown.otherImage(), there);
        label(g, otherName, there, Corner.TOP_LEFT);
        caption(g, shown.other(), there, Corner.BOTTOM_LEFT);
        label(g, Texts.get("compare.now"), bounds, Corner.TOP_LEFT);
        if (pin != null) {
            paintPin(g, there);
        }
    }

    private static void paint(Graphics2D g, BufferedImage image, Rectangle bounds) {
        g.drawImage(image, bounds.x, bounds.y, bounds.width, bounds.height, null);
    }

    private void paintSplit(Graphics2D g, Rectangle bounds, int x) {
        Shape clip = g.getClip();
        Rectangle left = new Rectangle(bounds.x, bounds.y, x - bounds.x, bounds.height);
        Rectangle right = new Rectangle(x, bounds.y, bounds.x + bounds.width - x, bounds.height);
        g.clip(right);
        paint(g, shown.otherImage(), bounds);
        label(g, otherName, right, Corner.TOP_RIGHT);
        caption(g, shown.other(), right, Corner.BOTTOM_RIGHT);
        g.setClip(clip);
        g.clip(left);
        paint(g, shown.nowImage(), bounds);
        label(g, Texts.get("compare.now"), left, Corner.TOP_LEFT);
        caption(g, shown.now(), left, Corner.BOTTOM_LEFT);
        g.setClip(clip);
        Mark.paintDivider(g, x, bounds.y, bounds.height);
    }

    private void caption(Graphics2D g, Picture picture, Rectangle bounds, Corner corner) {
        if (captions != null) {
            label(g, captions.apply(picture.studio()), bounds, corner);
        }
    }

    private void label(Graphics2D g, String text, Rectangle bounds, Corner corner) {
        Font font =
                getFont() == null ? UIManager.getFont("Label.font") : getFont().deriveFont(Font.BOLD);
        PictureLabel.paint(g, font, text, bounds, corner);
    }

    private void paintPin(Graphics2D g, Rectangle bounds) {
        double scale = (double) bounds.width / shown.now().image().width();
        Mark.paintPin(g, bounds.x + pin.getX() * scale, bounds.y + pin.getY() * scale);
    }

    /** The place of the picture, or of the one beside it, at a point of this component; null if there is none. */
    public Point2D pictureAt(Point point) {
        return arrangement().pictureAt(point);
    }

    /**
     * The picture that is seen at a point of this component, beyond the divider the other one; null if there is none.
     */
    public Picture shownAt(Point point) {
        return arrangement().shownAt(point);
    }

    private final class CanvasMouse extends MouseAdapter {

        /** Where the mouse was pressed; null where no click comes of it. */
        private Point pressed;

        private boolean nearDivider(MouseEvent event) {
            return splits() && !picking && Math.abs(event.getX() - arrangement().dividerX()) <= GRIP;
        }

        /** The mouse points now, and the keys no more. */
        private void point(MouseEvent event) {
            keyPointer.forget();
            mouseAt = event.getPoint();
        }

        @Override
        public void mousePressed(MouseEvent event) {
            requestFocusInWindow();
            pressed = event.getPoint();
            draggingDivider = nearDivider(event);
        }

        @Override
        public void mouseDragged(MouseEvent event) {
            mouseAt = event.getPoint();
            if (pressed != null && pressed.distance(mouseAt) > STILL) {
                pressed = null;
            }
            if (draggingDivider) {
                Rectangle bounds = pictureBounds();
                setDivider((double) (event.getX() - bounds.x) / bounds.width);
            } else {
                mouseMoved(event);
            }
        }

        @Override
        public void mouseMoved(MouseEvent event) {
            if (!picking) {
                setCursor(Cursor.getPredefinedCursor(
                        nearDivider(event) ? Cursor.E_RESIZE_CURSOR : Cursor.DEFAULT_CURSOR));
            }
            point(event);
            tellPointed();
        }

        @Override
        public void mouseExited(MouseEvent event) {
            mouseAt = null;
            tellPointed();
        }

        @Override
        public void mouseReleased(MouseEvent event) {
            if (!draggingDivider && pressed != null && event.getButton() == MouseEvent.BUTTON1) {
                point(event);
                click();
            }
            pressed = null;
            draggingDivider = false;
        }
    }
}
