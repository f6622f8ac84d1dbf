package tompkins.ui;

import java.util.Locale;
import tompkins.ui.picture.PictureCanvas;
import tompkins.ui.picture.SideMap;
import tompkins.ui.picture.VelocityArrow;

/** What is drawn over the picture on the screen, as the settings say; never into one that is saved. */
final class Signs {

    /** What can be drawn. */
    enum Sign {
        /** Where the camera flies. */
        ARROW(true),
        /** The scene from the side. */
        MAP(false);

        private final boolean usual;

        Sign(boolean usual) {
            this.usual = usual;
        }
    }

    private final PictureCanvas canvas;
    private final Settings settings;
    private final VelocityArrow arrow = new VelocityArrow();
    private final SideMap map = new SideMap();

    Signs(PictureCanvas canvas, Settings settings) {
        this.canvas = canvas;
        this.settings = settings;
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

    private static String name(Sign sign) {
        return sign.name().toLowerCase(Locale.ROOT);
    }

    private void update() {
        arrow.setShown(isShown(Sign.ARROW));
        map.setShown(isShown(Sign.MAP));
        canvas.repaint();
    }
}
