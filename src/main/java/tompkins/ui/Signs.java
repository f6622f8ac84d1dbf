package tompkins.ui;

import java.util.EnumSet;
import java.util.Locale;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Stream;
import tompkins.measure.OverlayKind;
import tompkins.ui.picture.PictureCanvas;
import tompkins.ui.picture.SceneOverlay;
import tompkins.ui.picture.SideMap;
import tompkins.ui.picture.VelocityArrow;

/**
 * What is drawn over the picture on the screen, as the settings say. A photograph that is saved has none of it; what
 * formulas say about the scene is also drawn into pictures that are copied and animations that are exported.
 */
final class Signs {

    /** What can be drawn. */
    enum Sign {
        /** Where the camera flies. */
        ARROW(true, null),
        /** The scene from the side. */
        MAP(false, null),
        /** Outlines of spheres. */
        OUTLINES(false, OverlayKind.OUTLINES),
        /** Axes of rods and edges of flat pieces. */
        LINES(false, OverlayKind.LINES),
        /** All of that, as a camera at rest sees it. */
        AT_REST(false, OverlayKind.AT_REST),
        /** All of that, where it is. */
        MEASURED(false, OverlayKind.MEASURED),
        /** Where things are seen, and where they are. */
        PLACES(false, OverlayKind.PLACES),
        /** Angles to the motion in the scene frame. */
        SCENE_GRID(false, OverlayKind.SCENE_GRID),
        /** Angles to the motion in the camera frame. */
        CAMERA_GRID(false, OverlayKind.CAMERA_GRID),
        /** What is across the motion. */
        HORIZON(false, OverlayKind.HORIZON),
        /** Circles of equal Doppler factor. */
        DOPPLER(false, OverlayKind.DOPPLER),
        /** Names of objects. */
        LABELS(false, OverlayKind.LABELS);

        private final boolean usual;

        /** Null if it says nothing about the scene. */
        private final OverlayKind kind;

        Sign(boolean usual, OverlayKind kind) {
            this.usual = usual;
            this.kind = kind;
        }

        /** Whether formulas work it out from the scene. */
        boolean isOfScene() {
            return kind != null;
        }
    }

    private final PictureCanvas canvas;
    private final Settings settings;
    private final VelocityArrow arrow = new VelocityArrow();
    private final SideMap map = new SideMap();
    private final SceneOverlay overlay;

    /** The signs on a canvas; {@code failures} is told by any thread what could not be worked out. */
    Signs(PictureCanvas canvas, Settings settings, Consumer<Throwable> failures) {
        this.canvas = canvas;
        this.settings = settings;
        overlay = new SceneOverlay(canvas::repaint, failures);
        canvas.addOverlay(overlay);
        canvas.addOverlay(map);
        canvas.addOverlay(arrow);
        update();
    }

    /** Whether something is drawn. */
    boolean isShown(Sign sign) {
        return settings.number(name(sign), sign.usual ? 1 : 0) != 0;
    }

    /** Draws something from now on, or not. */
    void setShown(Sign sign, boolean shown) {
        settings.setNumber(name(sign), shown ? 1 : 0);
        settings.save();
        update();
    }

    /** What formulas say about the scene, as far as it is drawn. */
    Set<OverlayKind> ofScene() {
        return overlay.shown();
    }

    /** Ends the work. */
    void close() {
        overlay.close();
    }

    private static String name(Sign sign) {
        return sign.name().toLowerCase(Locale.ROOT);
    }

    private void update() {
        arrow.setShown(isShown(Sign.ARROW));
        map.setShown(isShown(Sign.MAP));
        Set<OverlayKind> kinds = EnumSet.noneOf(OverlayKind.class);
        Stream.of(Sign.values())
                .filter(sign -> sign.isOfScene() && isShown(sign))
                .forEach(sign -> kinds.add(sign.kind));
        overlay.setShown(kinds);
        canvas.repaint();
    }
}
