package tompkins.ui.exchange;

import java.util.function.IntConsumer;
import javax.swing.JPanel;
import tompkins.property.Require;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.NumberField;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;

/** Asks for the size of pictures, which keep their proportions. */
public final class PictureSize {

    private final NumberField width;
    private final NumberField height;
    private final Note refused;
    private final RenderSettings own;
    private final Runnable changed;
    private Studio studio;

    /**
     * Proposes the size of a studio.
     *
     * @param refused says why a size cannot be had
     * @param changed notified of each other size
     */
    public PictureSize(Studio studio, Note refused, Runnable changed) {
        this.studio = studio;
        this.refused = refused;
        this.changed = changed;
        own = studio.settings();
        width = field("width", pixels -> scale("width", pixels, own.width()));
        height = field("height", pixels -> scale("height", pixels, own.height()));
        show();
    }

    private NumberField field(String key, IntConsumer taker) {
        String name = Texts.get("export." + key);
        return NumberField.within(
                key, 1, RenderSettings.LONGEST_SIDE, name, Texts.get("export." + key + "Tip"), refused, taker);
    }

    /** Adds its fields to rows of two columns, each with its label. */
    public void addTo(JPanel rows) {
        Rows.add(rows, Texts.get("export.width"), width.field(), "");
        Rows.add(rows, Texts.get("export.height"), height.field(), "");
    }

    private void scale(String side, int pixels, int before) {
        Require.within(side, pixels, 1, RenderSettings.LONGEST_SIDE);
        double scale = (double) pixels / before;
        studio = studio.withSettings(own.withSize(scaled(own.width(), scale), scaled(own.height(), scale)));
        show();
        changed.run();
    }

    private static int scaled(int pixels, double scale) {
        return Math.max(1, (int) Math.round(pixels * scale));
    }

    private void show() {
        width.show(studio.settings().width());
        height.show(studio.settings().height());
    }

    /** The studio with the size that was asked for. */
    public Studio studio() {
        return studio;
    }
}
