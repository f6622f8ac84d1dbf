package tompkins.ui.overlay;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.joml.Vector2dc;
import tompkins.measure.OverlayDrawing;
import tompkins.measure.OverlayKind;
import tompkins.trace.Frame;
import tompkins.trace.RenderPlan;
import tompkins.ui.picture.Mark;
import tompkins.ui.ray.LabelPlacer;
import tompkins.ui.widget.Drawing;
import tompkins.ui.widget.Texts;

/** Draws what formulas say over one picture, and writes names and numbers where there is room. */
final class OverlayPen {

    private static final double DOT = 2.5;
    private static final double RING = 6;

    /** Places at which a name is tried. */
    private static final int MOST_TRIED = 1000;

    private static final Map<OverlayKind, Color> COLOURS = Map.ofEntries(
            Map.entry(OverlayKind.OUTLINES, new Color(255, 215, 90)),
            Map.entry(OverlayKind.LINES, new Color(130, 230, 150)),
            Map.entry(OverlayKind.AT_REST, new Color(255, 255, 255)),
            Map.entry(OverlayKind.MEASURED, new Color(255, 150, 150)),
            Map.entry(OverlayKind.DOPPLER, new Color(120, 255, 190)),
            Map.entry(OverlayKind.WAVE_FRONTS, new Color(90, 230, 255)),
            Map.entry(OverlayKind.PLACES, new Color(255, 160, 120)),
            Map.entry(OverlayKind.SCENE_GRID, new Color(150, 205, 255)),
            Map.entry(OverlayKind.CAMERA_GRID, new Color(225, 225, 225)),
            Map.entry(OverlayKind.HORIZON, new Color(255, 140, 230)),
            Map.entry(OverlayKind.LABELS, Color.WHITE),
            Map.entry(OverlayKind.STARS, new Color(170, 190, 255)));

    private static final Set<OverlayKind> GHOSTS = Set.of(OverlayKind.AT_REST, OverlayKind.MEASURED);

    private static final List<OverlayKind> WRITTEN_FIRST = List.of(
            OverlayKind.LABELS,
            OverlayKind.STARS,
            OverlayKind.DOPPLER,
            OverlayKind.HORIZON,
            OverlayKind.CAMERA_GRID,
            OverlayKind.SCENE_GRID);

    private final Graphics2D g;
    private final Rectangle bounds;
    private final double scaleX;
    private final double scaleY;
    private final Font font;
    private final LabelPlacer written;

    OverlayPen(Graphics2D g, Rectangle bounds, RenderPlan plan, Font font) {
        this.g = g;
        this.bounds = bounds;
        this.font = font;
        written = new LabelPlacer(bounds, List.of());
        scaleX = (double) bounds.width / plan.width();
        scaleY = (double) bounds.height / plan.height();
    }

    /** Draws all of it. */
    void paint(List<OverlayDrawing> drawings, Rectangle visible) {
        for (OverlayDrawing drawing : drawings) {
            Mark.paintLines(g, lines(drawing), COLOURS.get(drawing.kind()), isFine(drawing.kind()));
            marks(drawing);
        }
        // names first: what is written later gives way
        drawings.stream()
                .filter(drawing -> GHOSTS.contains(drawing.kind()))
                .forEach(drawing -> writeGhost(drawing, visible));
        WRITTEN_FIRST.forEach(kind ->
                drawings.stream().filter(drawing -> drawing.kind() == kind).forEach(this::write));
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
        return Drawing.circle(x(place), y(place), radius);
    }

    /** Says what it is, above the highest of its places that is seen and has room. */
    private void writeGhost(OverlayDrawing drawing, Rectangle visible) {
        List<Vector2dc> highest = drawing.lines().stream()
                .flatMap(List::stream)
                .filter(place -> visible.contains(x(place), y(place)))
                .sorted(Comparator.comparingDouble(Vector2dc::y))
                .limit(MOST_TRIED)
                .toList();
        String text = Texts.get("overlay." + drawing.kind());
        for (Vector2dc place : highest) {
            if (write(drawing.kind(), text, place, List.of())) {
                return;
            }
        }
    }

    /** Writes what has room: nothing over what is written already. */
    private void write(OverlayDrawing drawing) {
        for (OverlayDrawing.Label label : drawing.labels()) {
            String text = label.frame() == null
                    ? label.text()
                    : Texts.get(label.frame() == Frame.SCENE ? "overlay.inScene" : "overlay.inCamera", label.text());
            write(drawing.kind(), text, label.position(), label.corners());
        }
    }

    /** Whether there was room: above, below or beside what is named, or else at its place. */
    private boolean write(OverlayKind kind, String text, Vector2dc place, List<Vector2dc> named) {
        double width = g.getFontMetrics(font).stringWidth(text);
        double height = font.getSize2D() + 2;
        List<Rectangle2D> rooms = new ArrayList<>();
        if (!named.isEmpty()) {
            Rectangle2D thing = new Rectangle2D.Double(x(place), y(place), 0, 0);
            named.forEach(corner -> thing.add(x(corner), y(corner)));
            double middle = x(place) - width / 2;
            double above = y(place) - height / 2;
            rooms.add(new Rectangle2D.Double(middle, thing.getMinY() - height - 2, width, height));
            rooms.add(new Rectangle2D.Double(middle, thing.getMaxY() + 2, width, height));
            rooms.add(new Rectangle2D.Double(thing.getMaxX() + 5, above, width, height));
            rooms.add(new Rectangle2D.Double(thing.getMinX() - width - 5, above, width, height));
        }
        double left = Math.min(x(place) + 5, bounds.getMaxX() - width - 4);
        rooms.add(new Rectangle2D.Double(left, Math.max(y(place) - 2 - height, bounds.y), width, height));
        Optional<Rectangle2D> free = written.takeFree(rooms);
        free.ifPresent(room -> Mark.paintText(g, font, text, room.getX(), room.getMaxY() - 2, COLOURS.get(kind)));
        return free.isPresent();
    }
}
