package tompkins.ui.picture;

import java.awt.Color;
import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
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

/** Shows the photograph as large as the window allows, alone or beside another one, and knows what lies under the mouse. */
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

    /** Where the mouse is, or what the keys point at; null if that is elsewhere. */
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
        Picture before = pictureUnderMouse();
        shown = pictures;
        repaint();
        Picture now = pictureUnderMouse();
        if (before != null && now != null && before.plan() != now.plan()) {
            tellMouse();
        }
    }

    private Picture pictureUnderMouse() {
        return mouseAt == null ? null : shownAt(mouseAt);
    }

    /** Tells what is under the mouse, which may change while the mouse rests. */
    private void tellMouse() {
        if (mouseAt != null) {
            mouse.over(pictureAt(mouseAt), shownAt(mouseAt));
        }
    }

    /** Reads what is at a point of this component; nothing if it is null. */
    void pointAt(Point point) {
        mouseAt = point;
        if (point == null) {
            mouse.over(null, null);
        }
        tellMouse();
    }

    /** Clicks at a point of this component, if there is a picture. */
    void click(Point point) {
        Point2D place = pictureAt(point);
        if (place != null) {
            mouse.clicked(place, shownAt(point));
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
        tellMouse();
        repaint();
    }

    /** Whether the other picture is shown alone for a while. */
    public void setOtherAlone(boolean alone) {
        otherAlone = alone;
        tellSize();
        tellMouse();
        repaint();
    }

    /** Where the divider is, from 0 at the left edge to 1. */
    void setDivider(double place) {
        divider = Math.max(0, Math.min(1, place));
        tellMouse();
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

    private double screenScale() {
        return getGraphicsConfiguration() == null
                ? 1
                : getGraphicsConfiguration().getDefaultTransform().getScaleX();
    }

    private void tellSize() {
        double scale = screenScale();
        resized.accept(new Dimension(
                Math.max(1, (int) Math.round(room() * scale)), Math.max(1, (int) Math.round(getHeight() * scale))));
    }

    @Override
    public void addNotify() {
        super.addNotify();
        tellSize();
    }

    /** Whether two pictures are seen. */
    public boolean showsTwo() {
        return splits() || isBeside() && shown.otherImage() != null;
    }

    private boolean splits() {
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
        g.setColor(Color.BLACK);
        g.fillRect(x - 2, bounds.y, 4, bounds.height);
        g.setColor(Color.WHITE);
        g.fillRect(x - 1, bounds.y, 2, bounds.height);
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        int middle = bounds.y + bounds.height / 2;
        g.fillRoundRect(x - 5, middle - 18, 10, 36, 10, 10);
        g.setColor(Color.DARK_GRAY);
        g.drawRoundRect(x - 5, middle - 18, 10, 36, 10, 10);
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

    /** The picture that is seen at a point of this component, beyond the divider the other one; null if there is none. */
    public Picture shownAt(Point point) {
        Point2D place = pictureAt(point);
        if (place == null) {
            return null;
        }
        boolean beyond =
                splits() && place.getX() > divider * shown.now().image().width();
        return beyond || isOverOther(point) || showsOtherAlone() ? shown.other() : shown.now();
    }

    private final class CanvasMouse extends MouseAdapter {

        private boolean nearDivider(MouseEvent event) {
            return splits() && !picking && Math.abs(event.getX() - dividerX()) <= GRIP;
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
            keyPointer.forget();
            pointAt(event.getPoint());
        }

        @Override
        public void mouseExited(MouseEvent event) {
            pointAt(null);
        }

        @Override
        public void mouseReleased(MouseEvent event) {
            if (!draggingDivider && event.getButton() == MouseEvent.BUTTON1) {
                click(event.getPoint());
            }
            draggingDivider = false;
        }
    }
}
