package tompkins.ui.editor;

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
import tompkins.image.PictureLabel;
import tompkins.measure.Grip;
import tompkins.measure.SeenLamp;
import tompkins.property.InvalidPropertyException;
import tompkins.studio.StudioPath;
import tompkins.trace.RenderPlan;
import tompkins.ui.model.StudioModel;
import tompkins.ui.photograph.WindowParts;
import tompkins.ui.picture.Mark;
import tompkins.ui.picture.NewestFirst;
import tompkins.ui.picture.Picture;
import tompkins.ui.picture.PictureCanvas;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.Texts;

/**
 * Moves objects and lamps with the mouse, in the picture: the point that is held stays under the pointer. A drag is one
 * step of the history. Where the sky is taken it turns the camera, as it does without the editor. Lamps are marked.
 */
public final class ObjectMouse extends MouseAdapter implements AutoCloseable {

    /** As long as it takes to read. */
    private static final int SAID_MILLISECONDS = 5000;

    private final WindowParts window;
    private final StudioModel model;
    private final PictureCanvas canvas;
    private final BooleanSupplier wanted;
    private final Supplier<StudioPath> chosen;
    private final Consumer<StudioPath> chooser;
    private final NewestFirst worker;

    /** The drag that goes on; null if none does. */
    private ObjectDrag drag;

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
        worker = new NewestFirst("tompkins-drag", window.view()::fail);
        fading.setRepeats(false);
        canvas.addMouseListener(this);
        canvas.addMouseMotionListener(this);
        canvas.addOverlay((g, shown, all, visible, free) -> paint(g, shown.plan(), all, free));
    }

    private void paint(Graphics2D g, RenderPlan shown, Rectangle all, Rectangle free) {
        if (wanted.getAsBoolean()) {
            SeenLamp.of(shown)
                    .forEach(lamp -> Mark.paintLamp(
                            g,
                            all.x + lamp.place().x() * all.width / shown.width(),
                            all.y + lamp.place().y() * all.height / shown.height()));
        }
        if (!said.isEmpty()) {
            PictureLabel.paint(g, Look.captions(), said, free, PictureLabel.Corner.TOP_MIDDLE);
        }
    }

    @Override
    public void mousePressed(MouseEvent event) {
        end();
        Point point = event.getPoint();
        Picture picture = canvas.shownAt(point);
        boolean takes = SwingUtilities.isLeftMouseButton(event)
                && !event.isShiftDown()
                && picture != null
                && picture == canvas.shown().now()
                && canvas.hand().isFreeAt(point)
                && wanted.getAsBoolean();
        if (takes) {
            drag = new ObjectDrag(model.studio(), picture.plan(), canvas.boundsAt(point), point, chosen.get());
            canvas.hand().take();
            // so that it is known what is held when the hand begins to move
            follow(drag, drag.from());
        }
    }

    @Override
    public void mouseDragged(MouseEvent event) {
        if (drag != null && canvas.hand().isDragging()) {
            follow(drag, drag.moveTo(event.getPoint()));
        }
    }

    private void follow(ObjectDrag asking, Point2D place) {
        worker.ask(() -> asking.to(place), answer -> {
            // it may have been given back meanwhile, or have been a click
            if (asking == drag && drag.hasMoved()) {
                show(answer);
            }
        });
    }

    private void show(ObjectDrag.Answer answer) {
        if (model.studio() != drag.held) {
            // somebody else has changed it since
            end();
            return;
        }
        answer.grip().ifPresent(grip -> move(grip, answer));
        boolean over = drag.endsWith(answer);
        if (!answer.refusal().isEmpty()) {
            refuse(answer.refusal());
        }
        if (over) {
            end();
        }
    }

    private void move(Grip grip, ObjectDrag.Answer answer) {
        if (!drag.begun) {
            drag.begun = true;
            chooser.accept(grip.path());
        }
        answer.moved().ifPresent(object -> {
            try {
                model.adjust(grip.path().with(model.studio(), object), drag);
                drag.held = model.studio();
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
        if (drag != null && drag.hasMoved()) {
            drag.released = true;
        } else {
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
        if (drag == null || !drag.hasMoved()) {
            return false;
        }
        if (model.studio() == drag.held) {
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
