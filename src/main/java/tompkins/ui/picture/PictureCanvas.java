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
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
import java.util.function.Consumer;
import javax.swing.JPanel;
import javax.swing.UIManager;
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

    /** Between two pictures beside each other. */
    private static final int GAP = 8;

    private final Consumer<Dimension> resized;
    private ScreenPicture shown = ScreenPicture.EMPTY;
    private Comparison comparison = Comparison.NONE;
    private String otherName = "";
    private boolean otherAlone;
    private double divider = 0.5;
    private boolean draggingDivider;
    private Point2D pin;
    private boolean picking;

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
        addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent event) {
                tellSize();
            }
        });
        // another screen may have other pixels
        addPropertyChangeListener("graphicsConfiguration", change -> tellSize());
        MouseAdapter adapter = new CanvasMouse();
        addMouseListener(adapter);
        addMouseMotionListener(adapter);
        keyPointer = new KeyPointer(this);
    }

    /** Tells a listener what the mouse does on the picture. */
    public void setMouse(Mouse listener) {
        mouse = listener;
    }

    /** Shows pictures. */
    public void show(ScreenPicture pictures) {
        Picture before = pointedPicture();
        shown = pictures;
        repaint();
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
        return keys != null ? seenAt(keys) : mouseAt == null ? null : shownAt(mouseAt);
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

    /** Whether the next click picks a point, which the cursor shows. */
    public void setPicking(boolean pick) {
        picking = pick;
        setCursor(Cursor.getPredefinedCursor(pick ? Cursor.CROSSHAIR_CURSOR : Cursor.DEFAULT_CURSOR));
    }

    /** Where the picture lies in this component. */
    public Rectangle pictureBounds() {
        Picture picture = shown.now();
        return picture == null
                ? new Rectangle(0, 0, room(), getHeight())
                : Fit.place(picture.image().width(), picture.image().height(), room(), getHeight());
    }

    /** Where the other picture lies, of the same size. */
    private Rectangle otherBounds() {
        Rectangle bounds = pictureBounds();
        if (isBeside()) {
            bounds.x += getWidth() - room();
        }
        return bounds;
    }

    private boolean isBeside() {
        return comparison == Comparison.BESIDE && !otherAlone;
    }

    /** The width that there is for each picture. */
    private int room() {
        return isBeside() ? Math.max(1, (getWidth() - GAP) / 2) : getWidth();
    }

    private void tellSize() {
        GraphicsConfiguration screen = getGraphicsConfiguration();
        double scale = screen == null ? 1 : screen.getDefaultTransform().getScaleX();
        resized.accept(new Dimension(
                Math.max(1, (int) Math.round(room() * scale)), Math.max(1, (int) Math.round(getHeight() * scale))));
    }

    /** Whether two pictures are seen. */
    public boolean showsTwo() {
        return splits() || isBeside() && shown.otherImage() != null;
    }

    boolean splits() {
        return comparison == Comparison.SPLIT && shown.otherImage() != null && !otherAlone;
    }

    private boolean showsOtherAlone() {
        return otherAlone && shown.otherImage() != null;
    }

    private int dividerX() {
        Rectangle bounds = pictureBounds();
        return bounds.x + (int) Math.round(divider * bounds.width);
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
        Rectangle bounds = pictureBounds();
        boolean difference = comparison == Comparison.DIFFERENCE && shown.difference() != null && !otherAlone;
        if (difference) {
            paint(g, shown.difference(), bounds);
            label(g, Texts.get("compare.differenceLabel", otherName), bounds, false);
        } else if (showsOtherAlone()) {
            paint(g, shown.otherImage(), bounds);
            label(g, otherName, bounds, false);
        } else {
            paint(g, shown.nowImage(), bounds);
        }
        if (comparison != Comparison.NONE && shown.other() != null && shown.otherImage() == null) {
            label(g, Texts.get("compare.otherShape", otherName), bounds, false);
        }
        if (splits()) {
            paintSplit(g, bounds);
        }
        if (isBeside()) {
            paintBeside(g, bounds);
        }
        if (pin != null) {
            paintPin(g, bounds);
        }
        keyPointer.paint(g);
    }

    private void paintBeside(Graphics2D g, Rectangle bounds) {
        if (shown.otherImage() != null) {
            Rectangle there = otherBounds();
            paint(g, shown.otherImage(), there);
            label(g, otherName, there, false);
            label(g, Texts.get("compare.now"), bounds, false);
            if (pin != null) {
                paintPin(g, there);
            }
        }
    }

    private static void paint(Graphics2D g, BufferedImage image, Rectangle bounds) {
        g.drawImage(image, bounds.x, bounds.y, bounds.width, bounds.height, null);
    }

    private void paintSplit(Graphics2D g, Rectangle bounds) {
        int x = dividerX();
        Shape clip = g.getClip();
        Rectangle left = new Rectangle(bounds.x, bounds.y, x - bounds.x, bounds.height);
        Rectangle right = new Rectangle(x, bounds.y, bounds.x + bounds.width - x, bounds.height);
        g.clip(right);
        paint(g, shown.otherImage(), bounds);
        label(g, otherName, right, true);
        g.setClip(clip);
        g.clip(left);
        label(g, Texts.get("compare.now"), left, false);
        g.setClip(clip);
        Mark.paintDivider(g, x, bounds.y, bounds.height);
    }

    private void label(Graphics2D g, String text, Rectangle bounds, boolean atRight) {
        Font font =
                getFont() == null ? UIManager.getFont("Label.font") : getFont().deriveFont(Font.BOLD);
        Caption.paint(g, font, text, bounds, atRight);
    }

    private void paintPin(Graphics2D g, Rectangle bounds) {
        double scale = (double) bounds.width / shown.now().image().width();
        Mark.paintPin(g, bounds.x + pin.getX() * scale, bounds.y + pin.getY() * scale);
    }

    private boolean isOverOther(Point point) {
        return isBeside() && shown.otherImage() != null && otherBounds().contains(point);
    }

    /** The place of the picture, or of the one beside it, at a point of this component; null if there is none. */
    public Point2D pictureAt(Point point) {
        Rectangle bounds = isOverOther(point) ? otherBounds() : pictureBounds();
        if (shown.now() == null || !bounds.contains(point)) {
            return null;
        }
        double scale = (double) shown.now().image().width() / bounds.width;
        int right = shown.now().image().width() - 1;
        int bottom = shown.now().image().height() - 1;
        int column = Math.min(right, (int) ((point.x + 0.5 - bounds.x) * scale));
        int row = Math.min(bottom, (int) ((point.y + 0.5 - bounds.y) * scale));
        return new Point2D.Double(column + 0.5, row + 0.5);
    }

    /**
     * The picture that is seen at a point of this component, beyond the divider the other one; null if there is none.
     */
    public Picture shownAt(Point point) {
        Point2D place = pictureAt(point);
        if (place == null) {
            return null;
        }
        return isOverOther(point) ? shown.other() : seenAt(place);
    }

    /** The picture that is seen at a place of the present one. */
    private Picture seenAt(Point2D place) {
        boolean beyond =
                splits() && place.getX() > divider * shown.now().image().width();
        return beyond || showsOtherAlone() ? shown.other() : shown.now();
    }

    private final class CanvasMouse extends MouseAdapter {

        private boolean nearDivider(MouseEvent event) {
            return splits() && !picking && Math.abs(event.getX() - dividerX()) <= GRIP;
        }

        /** The mouse points now, and the keys no more. */
        private void point(MouseEvent event) {
            keyPointer.forget();
            mouseAt = event.getPoint();
        }

        @Override
        public void mousePressed(MouseEvent event) {
            requestFocusInWindow();
            draggingDivider = nearDivider(event);
        }

        @Override
        public void mouseDragged(MouseEvent event) {
            mouseAt = event.getPoint();
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
            if (!draggingDivider && event.getButton() == MouseEvent.BUTTON1) {
                point(event);
                click();
            }
            draggingDivider = false;
        }
    }
}
