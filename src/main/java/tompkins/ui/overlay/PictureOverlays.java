package tompkins.ui.overlay;

import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import tompkins.measure.OverlayKind;
import tompkins.ui.model.Settings;
import tompkins.ui.picture.Asker;
import tompkins.ui.picture.PictureCanvas;

/**
 * What is drawn over the picture on the screen, as the settings say. A photograph that is saved has none of it; what
 * formulas say about the scene is also drawn into pictures that are copied and animations that are exported.
 */
public final class PictureOverlays {

    /** Where the camera flies. */
    public static final String ARROW = "arrow";

    /** The setting of the map: 0 is none, else the axis, counted from 1. */
    private static final String MAP = "map";

    /** How many pictures of a ride there are in a second. */
    public static final String RATE = "rate";

    private final PictureCanvas canvas;
    private final Settings settings;
    private final VelocityArrow arrow = new VelocityArrow();
    private final SceneMap map = new SceneMap();
    private final SceneOverlay overlay;

    /** The overlays of a canvas; {@code asker} computes what takes a while. */
    public PictureOverlays(PictureCanvas canvas, Settings settings, Asker asker) {
        this.canvas = canvas;
        this.settings = settings;
        overlay = new SceneOverlay(canvas::repaint, asker);
        canvas.addOverlay(overlay);
        canvas.addOverlay(map);
        canvas.addOverlay(arrow);
        update();
    }

    /** The name of what formulas say about the scene. */
    public static String name(OverlayKind kind) {
        return kind.name().toLowerCase(Locale.ROOT);
    }

    /** Whether the overlay of a name is drawn; at first only the arrow is. */
    public boolean isShown(String name) {
        return settings.number(name, name.equals(ARROW) ? 1 : 0) != 0;
    }

    /** Draws an overlay from now on, or not. */
    public void setShown(String name, boolean shown) {
        settings.setNumber(name, shown ? 1 : 0);
        settings.save();
        update();
    }

    /** The axis along which the map of the scene looks; empty if there is none. */
    public Optional<MapAxis> map() {
        return Stream.of(MapAxis.values())
                .filter(axis -> axis.setting == settings.number(MAP, 0))
                .findFirst();
    }

    /** Shows the map along another axis from now on, or none. */
    public void setMap(Optional<MapAxis> axis) {
        settings.setNumber(MAP, axis.map(each -> each.setting).orElse(0));
        settings.save();
        update();
    }

    /** What formulas say about the scene, as far as it is drawn. */
    public Set<OverlayKind> ofScene() {
        return overlay.shown();
    }

    private void update() {
        arrow.setShown(isShown(ARROW));
        map.setShown(map());
        overlay.setShown(Stream.of(OverlayKind.values())
                .filter(kind -> isShown(name(kind)))
                .collect(Collectors.toSet()));
        canvas.repaint();
    }
}
