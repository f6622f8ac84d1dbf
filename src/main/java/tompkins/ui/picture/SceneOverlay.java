package tompkins.ui.picture;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import org.joml.Vector2dc;
import tompkins.image.PictureLabel;
import tompkins.measure.OverlayDrawing;
import tompkins.measure.OverlayKind;
import tompkins.measure.Overlays;
import tompkins.measure.Projection;
import tompkins.measure.SceneShapes;
import tompkins.sceneobject.FrameObjects;
import tompkins.studio.Studio;
import tompkins.trace.Frame;
import tompkins.trace.RenderPlan;
import tompkins.ui.widget.Texts;

/**
 * What formulas say about a picture, drawn over it: outlines, axes, places, grids. It follows each picture. If the
 * shutter opens at another time for each place, that takes a while: it is then worked out by a thread of its own, and
 * nothing is drawn until it is there.
 */
public final class SceneOverlay implements Overlay, AutoCloseable {

    private static final double DOT = 2.5;
    private static final double RING = 6;

    /** Size of the type in a picture that leaves the program, as a share of its height. */
    private static final double HEIGHT_SHARE = 1 / 36.0;

    private static final double SMALLEST_TYPE = 9;

    private static final Map<OverlayKind, Color> COLOURS = Map.of(
            OverlayKind.OUTLINES, new Color(255, 215, 90),
            OverlayKind.LINES, new Color(130, 230, 150),
            OverlayKind.AT_REST, new Color(255, 255, 255),
            OverlayKind.MEASURED, new Color(255, 150, 150),
            OverlayKind.DOPPLER, new Color(120, 255, 190),
            OverlayKind.PLACES, new Color(255, 160, 120),
            OverlayKind.SCENE_GRID, new Color(150, 205, 255),
            OverlayKind.CAMERA_GRID, new Color(225, 225, 225),
            OverlayKind.HORIZON, new Color(255, 140, 230),
            OverlayKind.LABELS, Color.WHITE);

    private static final List<OverlayKind> WRITTEN_FIRST = List.of(
            OverlayKind.LABELS,
            OverlayKind.DOPPLER,
            OverlayKind.HORIZON,
            OverlayKind.CAMERA_GRID,
            OverlayKind.SCENE_GRID);

    /** What is drawn over the picture of a plan. */
    private record Drawn(RenderPlan plan, Set<OverlayKind> kinds, List<OverlayDrawing> drawings, String note) {}

    private record Question(RenderPlan plan, Set<OverlayKind> kinds) {}

    /** The shapes of the scene that was drawn last, which many plans share. */
    private record Known(List<FrameObjects> frames, SceneShapes shapes) {}

    private final Runnable repaint;
    private final NewestFirst<Question> worker;

    /** The newest first; two, because two pictures may be shown. */
    private final List<Drawn> drawn = new CopyOnWriteArrayList<>();

    private Set<OverlayKind> shown = EnumSet.noneOf(OverlayKind.class);
    private Known known = new Known(List.of(), null);

    /**
     * An overlay that draws nothing yet.
     *
     * @param repaint called by the event thread when more can be drawn
     * @param failures told by another thread what could not be worked out
     */
    public SceneOverlay(Runnable repaint, Consumer<Throwable> failures) {
        this.repaint = repaint;
        worker = new NewestFirst<>("tompkins-overlay", this::answer, (question, error) -> failures.accept(error));
    }

    /** Draws these from now on. */
    public void setShown(Set<OverlayKind> kinds) {
        shown = Set.copyOf(kinds);
        drawn.clear();
    }

    /** What is drawn. */
    public Set<OverlayKind> shown() {
        return shown;
    }

    @Override
    public boolean isOfAllPictures() {
        return true;
    }

    @Override
    public void paint(Graphics2D g, Picture picture, Rectangle bounds, Rectangle visible, Rectangle free) {
        if (shown.isEmpty()) {
            return;
        }
        Drawn now = drawn(picture.plan());
        if (now != null) {
            new Pen(g, bounds, now.plan, UIManager.getFont("small.font")).paint(now, visible);
        }
    }

    /** Draws all of it into a picture that leaves the program, in its own size; called by any thread. */
    public static void paint(BufferedImage image, Studio studio, Set<OverlayKind> kinds) {
        if (kinds.isEmpty()) {
            return;
        }
        RenderPlan plan = RenderPlan.of(studio);
        Rectangle whole = new Rectangle(image.getWidth(), image.getHeight());
        float size = (float) Math.max(SMALLEST_TYPE, HEIGHT_SHARE * whole.height);
        Graphics2D g = image.createGraphics();
        new Pen(g, whole, plan, new Font(Font.SANS_SERIF, Font.PLAIN, 1).deriveFont(size))
                .paint(draw(plan, kinds, SceneShapes.of(plan.sceneFrames())), whole);
        g.dispose();
    }

    /** What is drawn over a picture; null while that is worked out. */
    private Drawn drawn(RenderPlan plan) {
        for (Drawn each : drawn) {
            if (each.plan == plan && each.kinds.equals(shown)) {
                return each;
            }
        }
        if (!isQuick(plan.studio())) {
            worker.submit(new Question(plan, shown));
            return null;
        }
        Drawn made = draw(plan, shown, shapes(plan));
        keep(made);
        return made;
    }

    private static boolean isQuick(Studio studio) {
        return new Projection(studio, 1, 1).hasOneTime();
    }

    private void answer(Question question) {
        Drawn made = draw(question.plan, question.kinds, shapes(question.plan));
        SwingUtilities.invokeLater(() -> {
            if (made.kinds.equals(shown)) {
                keep(made);
                repaint.run();
            }
        });
    }

    private void keep(Drawn made) {
        drawn.add(0, made);
        while (drawn.size() > 2) {
            drawn.remove(2);
        }
    }

    private synchronized SceneShapes shapes(RenderPlan plan) {
        if (known.shapes == null || known.frames != plan.sceneFrames()) {
            known = new Known(plan.sceneFrames(), SceneShapes.of(plan.sceneFrames()));
        }
        return known.shapes;
    }

    private static Drawn draw(RenderPlan plan, Set<OverlayKind> kinds, SceneShapes shapes) {
        Overlays overlays = new Overlays(Projection.of(plan.studio()), shapes);
        List<OverlayDrawing> drawings = Stream.of(OverlayKind.values())
                .filter(kinds::contains)
                .map(overlays::draw)
                .toList();
        return new Drawn(plan, Set.copyOf(kinds), drawings, note(plan, shapes));
    }

    /** Says in one line where the drawing may not agree with the picture; empty if it agrees. */
    private static String note(RenderPlan plan, SceneShapes shapes) {
        List<String> notes = new ArrayList<>();
        if (plan.studio().camera().hasWideAperture()) {
            notes.add("aperture");
        }
        if (plan.blursInTime()) {
            notes.add("exposure");
        }
        if (!plan.studio().cameraFrame().isEmpty()) {
            notes.add("beforeLens");
        }
        if (shapes.turnsRays()) {
            notes.add("turned");
        }
        if (!shapes.complete()) {
            notes.add("many");
        }
        return notes.isEmpty()
                ? ""
                : Texts.get("overlay.note")
                        + notes.stream()
                                .map(note -> Texts.get("overlay.note." + note))
                                .collect(Collectors.joining("; "));
    }

    @Override
    public void close() {
        worker.close();
        drawn.clear();
    }

    /** Draws in one picture. */
    private static final class Pen {

        private final Graphics2D g;
        private final Rectangle bounds;
        private final double scaleX;
        private final double scaleY;
        private final Font font;
        private final List<Rectangle2D> written = new ArrayList<>();

        Pen(Graphics2D g, Rectangle bounds, RenderPlan plan, Font font) {
            this.g = g;
            this.bounds = bounds;
            this.font = font;
            scaleX = (double) bounds.width / plan.width();
            scaleY = (double) bounds.height / plan.height();
        }

        void paint(Drawn drawn, Rectangle visible) {
            for (OverlayDrawing drawing : drawn.drawings) {
                Mark.paintLines(g, lines(drawing), COLOURS.get(drawing.kind()), isFine(drawing.kind()));
                marks(drawing);
            }
            // names first, because later writing gives way
            WRITTEN_FIRST.forEach(kind -> drawn.drawings.stream()
                    .filter(drawing -> drawing.kind() == kind)
                    .forEach(this::write));
            if (!drawn.note.isEmpty()) {
                PictureLabel.paint(g, font, drawn.note, visible, PictureLabel.Corner.TOP_RIGHT);
            }
        }

        private static boolean isFine(OverlayKind kind) {
            return switch (kind) {
                case SCENE_GRID, CAMERA_GRID, AT_REST, MEASURED -> true;
                default -> false;
            };
        }

        private double x(Vector2dc place) {
            return bounds.x + place.x() * scaleX;
        }

        private double y(Vector2dc place) {
            return bounds.y + place.y() * scaleY;
        }

        private Path2D lines(OverlayDrawing drawing) {
            Path2D path = new Path2D.Double();
            for (List<Vector2dc> line : drawing.lines()) {
                path.moveTo(x(line.get(0)), y(line.get(0)));
                for (Vector2dc place : line.subList(1, line.size())) {
                    path.lineTo(x(place), y(place));
                }
            }
            return path;
        }

        private void marks(OverlayDrawing drawing) {
            Color colour = COLOURS.get(drawing.kind());
            Path2D marks = new Path2D.Double();
            drawing.rings().forEach(place -> marks.append(circle(place, RING), false));
            drawing.dots().forEach(place -> marks.append(circle(place, DOT), false));
            Mark.paintLines(g, marks, colour, false);
            g.setColor(colour);
            drawing.dots().forEach(place -> g.fill(circle(place, DOT)));
        }

        private Ellipse2D circle(Vector2dc place, double radius) {
            return new Ellipse2D.Double(x(place) - radius, y(place) - radius, 2 * radius, 2 * radius);
        }

        /** Writes a text if there is room, and never over another text. */
        private void write(OverlayDrawing drawing) {
            for (OverlayDrawing.Label label : drawing.labels()) {
                String text = label.frame() == null
                        ? label.text()
                        : Texts.get(
                                label.frame() == Frame.SCENE ? "overlay.inScene" : "overlay.inCamera", label.text());
                double width = g.getFontMetrics(font).stringWidth(text);
                double left = Math.min(x(label.place()) + 5, bounds.getMaxX() - width - 4);
                double bottom = Math.max(y(label.place()) - 4, bounds.y + font.getSize2D() + 2);
                Rectangle2D room = new Rectangle2D.Double(left, bottom - font.getSize2D(), width, font.getSize2D() + 2);
                if (written.stream().noneMatch(room::intersects)) {
                    written.add(room);
                    Mark.paintText(g, font, text, left, bottom, COLOURS.get(drawing.kind()));
                }
            }
        }
    }
}
