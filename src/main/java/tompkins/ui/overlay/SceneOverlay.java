package tompkins.ui.overlay;

import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.UIManager;
import tompkins.camera.EyeView;
import tompkins.image.PictureLabel;
import tompkins.measure.OverlayDrawing;
import tompkins.measure.OverlayKind;
import tompkins.measure.Overlays;
import tompkins.measure.Projection;
import tompkins.measure.SceneShapes;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;
import tompkins.ui.picture.Asker;
import tompkins.ui.picture.Overlay;
import tompkins.ui.picture.Picture;
import tompkins.ui.widget.Texts;
import tompkins.world.InertialFrame;

/**
 * What formulas say about a picture, drawn over it: outlines, axes, places, grids. It follows each picture. If the
 * shutter opens at another time for each place, if rays are followed, or if lines turn, that takes a while: it is then
 * computed by another thread, and nothing is drawn until it is there.
 */
public final class SceneOverlay implements Overlay {

    /** Size of the type in a picture that leaves the program, as a share of its height. */
    private static final double HEIGHT_SHARE = 1 / 36.0;

    private static final double SMALLEST_TYPE = 9;

    /** What is drawn over the picture of a plan. */
    private record Drawn(RenderPlan plan, Set<OverlayKind> kinds, List<OfEye> eyes, String note) {

        void paint(Graphics2D g, Rectangle bounds, Font font, Rectangle visible, Rectangle free) {
            for (OfEye eye : eyes) {
                Graphics2D own = (Graphics2D) g.create();
                if (plan.studio().camera().stereo().layout().hasHalves()) {
                    own.clip(eye.part(bounds, plan));
                }
                new OverlayPen(own, bounds, plan, font).paint(eye.drawings, visible);
                own.dispose();
            }
            if (!note.isEmpty()) {
                // the top is for the line of a ride
                PictureLabel.paint(g, font, note, free, PictureLabel.Corner.BOTTOM_LEFT);
            }
        }
    }

    /** What is drawn over the part of the picture that an eye has. */
    private record OfEye(EyeView view, List<OverlayDrawing> drawings) {

        Rectangle2D part(Rectangle bounds, RenderPlan plan) {
            double scaleX = (double) bounds.width / plan.width();
            double scaleY = (double) bounds.height / plan.height();
            return new Rectangle2D.Double(
                    bounds.x + view.column() * scaleX,
                    bounds.y + view.row() * scaleY,
                    view.width() * scaleX,
                    view.height() * scaleY);
        }
    }

    /** The shapes of the scene that was drawn last, which many plans share. */
    private record Known(List<InertialFrame> frames, SceneShapes shapes) {}

    private final Runnable repaint;
    private final Asker asker;

    /** The newest first; two, because two pictures may be shown. */
    private final List<Drawn> drawn = new CopyOnWriteArrayList<>();

    private Set<OverlayKind> shown = EnumSet.noneOf(OverlayKind.class);
    private Known known = new Known(List.of(), null);

    /**
     * An overlay that draws nothing yet.
     *
     * @param repaint called by the event thread when more can be drawn
     * @param asker computes what takes a while
     */
    public SceneOverlay(Runnable repaint, Asker asker) {
        this.repaint = repaint;
        this.asker = asker;
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
            now.paint(g, bounds, UIManager.getFont("small.font"), visible, free);
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
        Font font = new Font(Font.SANS_SERIF, Font.PLAIN, 1).deriveFont(size);
        Rectangle aboveCaption = new Rectangle(whole.width, whole.height - PictureLabel.height(g, font));
        draw(plan, kinds, SceneShapes.of(plan.world().frames())).paint(g, whole, font, whole, aboveCaption);
        g.dispose();
    }

    /** What is drawn over a picture; null while that is computed. */
    private Drawn drawn(RenderPlan plan) {
        for (Drawn each : drawn) {
            if (each.plan == plan && each.kinds.equals(shown)) {
                return each;
            }
        }
        if (!isQuick(plan, shown, shapes(plan))) {
            Set<OverlayKind> kinds = shown;
            // the next is asked for when the picture is painted with this one
            if (!asker.isAsked(this)) {
                asker.ask(this, () -> draw(plan, kinds, shapes(plan)), this::take);
            }
            return null;
        }
        Drawn made = draw(plan, shown, shapes(plan));
        keep(made);
        return made;
    }

    private static boolean isQuick(RenderPlan plan, Set<OverlayKind> kinds, SceneShapes shapes) {
        boolean followsRays = kinds.contains(OverlayKind.WAVE_FRONTS) && plan.hasFlashes();
        boolean followsTurns = shapes.lines().stream().anyMatch(line -> line.turn() != null)
                && !Collections.disjoint(kinds, OverlayKind.OF_LINES);
        return !followsRays && !followsTurns && Projection.of(plan.studio()).hasOneTime();
    }

    private void take(Drawn made) {
        if (made.kinds.equals(shown)) {
            keep(made);
        }
        repaint.run();
    }

    private void keep(Drawn made) {
        drawn.add(0, made);
        while (drawn.size() > 2) {
            drawn.remove(2);
        }
    }

    private synchronized SceneShapes shapes(RenderPlan plan) {
        if (known.shapes == null || known.frames != plan.world().frames()) {
            known = new Known(plan.world().frames(), SceneShapes.of(plan.world().frames()));
        }
        return known.shapes;
    }

    private static Drawn draw(RenderPlan plan, Set<OverlayKind> kinds, SceneShapes shapes) {
        List<OfEye> eyes = Projection.ofEyes(plan.studio()).stream()
                .map(projection -> draw(new Overlays(projection, shapes, plan), projection.view(), kinds))
                .toList();
        return new Drawn(plan, Set.copyOf(kinds), eyes, note(plan, shapes, kinds));
    }

    private static OfEye draw(Overlays overlays, EyeView view, Set<OverlayKind> kinds) {
        List<OverlayDrawing> drawings = Stream.of(OverlayKind.values())
                .filter(kinds::contains)
                .map(overlays::draw)
                .toList();
        return new OfEye(view, drawings);
    }

    /** Says in one line where the drawing may not agree with the picture; empty if it agrees. */
    private static String note(RenderPlan plan, SceneShapes shapes, Set<OverlayKind> kinds) {
        boolean byFormulas = !kinds.equals(Set.of(OverlayKind.WAVE_FRONTS));
        List<String> notes = new ArrayList<>();
        if (plan.studio().camera().hasWideAperture()) {
            notes.add("aperture");
        }
        if (plan.blursInTime()) {
            notes.add("exposure");
        }
        if (byFormulas && !plan.studio().cameraFrame().isEmpty()) {
            notes.add("beforeLens");
        }
        if (byFormulas && shapes.turnsRays()) {
            notes.add("turned");
        }
        if (byFormulas && !shapes.complete()) {
            notes.add("many");
        }
        return notes.isEmpty()
                ? ""
                : Texts.get("overlay.note")
                        + notes.stream()
                                .map(note -> Texts.get("overlay.note." + note))
                                .collect(Collectors.joining("; "));
    }
}
