package tompkins.ui.editor;

import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Point2D;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import javax.swing.UIManager;
import tompkins.image.PictureLabel;
import tompkins.measure.Grip;
import tompkins.property.InvalidPropertyException;
import tompkins.studio.Studio;
import tompkins.studio.StudioPath;
import tompkins.ui.model.StudioModel;
import tompkins.ui.photograph.WindowParts;
import tompkins.ui.picture.NewestFirst;
import tompkins.ui.picture.Picture;
import tompkins.ui.picture.PictureCanvas;
import tompkins.ui.widget.Texts;

/**
 * Moves objects with the mouse, in the picture: the point that is held stays under the pointer. A drag is one step of
 * the history. Where the sky is taken it turns the camera, as it does without the editor.
 */
public final class ObjectMouse extends MouseAdapter implements AutoCloseable {

    /** As long as it takes to read. */
    private static final int SAID_MILLISECONDS = 5000;

    private record Question(ObjectDrag drag, Point2D place) {}

    private final WindowParts window;
    private final StudioModel model;
    private final PictureCanvas canvas;
    private final BooleanSupplier wanted;
    private final Supplier<StudioPath> chosen;
    private final Consumer<StudioPath> chooser;
    private final NewestFirst<Question> worker;

    /** The drag that goes on; null if none does. */
    private ObjectDrag drag;

    private Picture picture;
    private Rectangle bounds;

    /** Where the pointer was last; null before it has moved. */
    private Point2D pointer;

    /** The studio as it is unless somebody else changes it. */
    private Studio held;

    private boolean begun;
    private boolean released;

    /** What is said in the picture for a while; empty if nothing is. */
    private String said = "";

    private final Timer fading = new Timer(SAID_MILLISECONDS, event -> endSaying());

    private boolean saidOfSky;

    /**
     * Moves objects in the picture of a window.
     *
     * @param wanted whether a drag moves objects now
     * @param chosen the way to the part that is chosen in the editor
     * @param chooser chooses an object there
     */
    public ObjectMouse(
            WindowParts window, BooleanSupplier wanted, Supplier<StudioPath> chosen, Consumer<StudioPath> chooser) {
        this.window = window;
        this.wanted = wanted;
        this.chosen = chosen;
        this.chooser = chooser;
        model = window.model();
        canvas = window.view().canvas();
        worker = new NewestFirst<>(
                "tompkins-drag",
                this::follow,
                (question, error) -> window.view().fail(error));
        fading.setRepeats(false);
        canvas.addMouseListener(this);
        canvas.addMouseMotionListener(this);
        canvas.addOverlay((g, shown, all, visible, free) -> paint(g, free));
    }

    private void paint(Graphics2D g, Rectangle free) {
        if (!said.isEmpty()) {
            Font font = UIManager.getFont("Label.font").deriveFont(Font.BOLD);
            PictureLabel.paint(g, font, said, free, PictureLabel.Corner.TOP_MIDDLE);
        }
    }

    @Override
    public void mousePressed(MouseEvent event) {
        end();
        Point point = event.getPoint();
        picture = canvas.shownAt(point);
        boolean takes = SwingUtilities.isLeftMouseButton(event)
                && !event.isShiftDown()
                && picture != null
                && picture == canvas.shown().now()
                && canvas.hand().isFreeAt(point)
                && wanted.getAsBoolean();
        if (takes) {
            bounds = canvas.boundsAt(point);
            held = model.studio();
            pointer = null;
            begun = false;
            released = false;
            drag = new ObjectDrag(held, picture.plan(), place(point), chosen.get());
            canvas.hand().take();
            // so that it is known what is held when the hand begins to move
            worker.submit(new Question(drag, place(point)));
        }
    }

    /** The place of the picture at a point of the canvas, in its pixels; beside the picture, at its edge. */
    private Point2D place(Point point) {
        int width = picture.plan().width();
        int height = picture.plan().height();
        double x = (point.x + 0.5 - bounds.x) / bounds.width * width;
        double y = (point.y + 0.5 - bounds.y) / bounds.height * height;
        return new Point2D.Double(Math.max(0, Math.min(width, x)), Math.max(0, Math.min(height, y)));
    }

    @Override
    public void mouseDragged(MouseEvent event) {
        if (drag != null && canvas.hand().isDragging()) {
            pointer = place(event.getPoint());
            worker.submit(new Question(drag, pointer));
        }
    }

    /** Called by the worker. */
    private void follow(Question question) {
        ObjectDrag.Answer answer = question.drag.to(question.place);
        SwingUtilities.invokeLater(() -> {
            // it may have been given back meanwhile, or have been a click
            if (answer.drag() == drag && pointer != null) {
                show(answer);
            }
        });
    }

    private void show(ObjectDrag.Answer answer) {
        if (model.studio() != held) {
            // somebody else has changed it since
            end();
            return;
        }
        answer.grip().ifPresent(grip -> move(grip, answer));
        if (!answer.refusal().isEmpty()) {
            refuse(answer.refusal());
        }
        if (released && answer.place() == pointer) {
            end();
        }
    }

    private void move(Grip grip, ObjectDrag.Answer answer) {
        if (!begun) {
            begun = true;
            chooser.accept(grip.path());
        }
        answer.moved().ifPresent(object -> {
            try {
                model.adjust(grip.path().with(model.studio(), object), drag);
                held = model.studio();
            } catch (InvalidPropertyException tooFar) {
                window.view().fail(tooFar);
            }
        });
    }

    private void refuse(String refusal) {
        if (refusal.equals(ObjectDrag.SKY)) {
            canvas.hand().give();
            drag = null;
            if (saidOfSky) {
                return;
            }
            saidOfSky = true;
        }
        said = Texts.get(refusal);
        canvas.repaint();
        fading.restart();
    }

    private void endSaying() {
        said = "";
        canvas.repaint();
    }

    @Override
    public void mouseReleased(MouseEvent event) {
        released = true;
        if (pointer == null) {
            end();
        }
    }

    private void end() {
        if (drag != null) {
            model.endGesture(drag);
            drag = null;
        }
    }

    /** Gives back what is held; false if nothing is. */
    public boolean giveBack() {
        if (drag == null || pointer == null) {
            return false;
        }
        if (model.studio() == held) {
            model.takeBack(drag);
        }
        end();
        return true;
    }

    @Override
    public void close() {
        fading.stop();
        worker.close();
    }
}
