package tompkins.ui.overlay;

import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import tompkins.measure.OverlayKind;
import tompkins.ui.model.Settings;
import tompkins.ui.model.StudioModel;
import tompkins.ui.picture.Asker;
import tompkins.ui.picture.PictureCanvas;

/**
 * What is drawn over the picture on the screen. The settings keep whether the arrow is; what belongs to one scene, such
 * as outlines and the map, goes when another is opened. A photograph that is saved has none of it; what formulas say
 * about the scene is also drawn into pictures that are copied and animations that are exported.
 */
public final class PictureOverlays {

    /** Where the camera flies. */
    private static final String ARROW = "arrow";

    private final PictureCanvas canvas;
    private final Settings settings;
    private final VelocityArrow arrow = new VelocityArrow();
    private final SceneMap map = new SceneMap();
    private final SceneOverlay overlay;
    private final Set<OverlayKind> kinds = EnumSet.noneOf(OverlayKind.class);
    private Optional<MapAxis> axis = Optional.empty();

    /** The overlays of the canvas of a model; {@code asker} computes what takes a while. */
    public PictureOverlays(StudioModel model, PictureCanvas canvas, Settings settings, Asker asker) {
        this.canvas = canvas;
        this.settings = settings;
        overlay = new SceneOverlay(canvas::repaint, asker);
        canvas.addOverlay(overlay);
        canvas.addOverlay(map);
        canvas.addOverlay(arrow);
        model.addOpenListener(this::beginScene);
        arrow.setShown(isArrowShown());
    }

    /** Whether the arrow is drawn; it is at first. */
    public boolean isArrowShown() {
        return settings.number(ARROW, 1) != 0;
    }

    /** Draws the arrow from now on, or not. */
    public void setArrowShown(boolean shown) {
        settings.setNumber(ARROW, shown ? 1 : 0);
        arrow.setShown(shown);
        canvas.repaint();
    }

    /** Whether what formulas say is drawn. */
    public boolean isShown(OverlayKind kind) {
        return kinds.contains(kind);
    }

    /** Draws what formulas say, until another scene is opened, or not. */
    public void setShown(OverlayKind kind, boolean shown) {
        if (shown) {
            kinds.add(kind);
        } else {
            kinds.remove(kind);
        }
        overlay.setShown(kinds);
        canvas.repaint();
    }

    /** The axis along which the map of the scene looks; empty if there is none. */
    public Optional<MapAxis> map() {
        return axis;
    }

    /** Shows the map along another axis, until another scene is opened, or none. */
    public void setMap(Optional<MapAxis> along) {
        axis = along;
        map.setShown(along);
        canvas.repaint();
    }

    private void beginScene() {
        kinds.clear();
        overlay.setShown(kinds);
        setMap(Optional.empty());
    }

    /** What formulas say about the scene, as far as it is drawn. */
    public Set<OverlayKind> ofScene() {
        return overlay.shown();
    }
}
