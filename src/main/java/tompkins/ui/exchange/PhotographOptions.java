package tompkins.ui.exchange;

import java.util.function.Consumer;
import javax.swing.BorderFactory;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.NumberField;
import tompkins.ui.widget.NumberKind;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Wording;

/**
 * Asks how large a photograph should be, and how good: the samples of each pixel, or the error until which they are
 * taken.
 */
final class PhotographOptions extends Part {

    private final Note refused = Note.ofLines(3);
    private final PictureSize size;
    private final NumberField samples;
    private final NumberField error;
    private RenderSettings quality;

    /** Proposes the size and the quality of a studio. */
    PhotographOptions(Studio studio) {
        super(Rows.of("wrap 2, hidemode 3, gap 8 5", "[][grow,fill]"));
        size = new PictureSize(studio, refused, () -> {});
        panel.setBorder(BorderFactory.createEmptyBorder(0, 12, 0, 0));
        size.addTo(panel);
        quality = studio.settings();
        samples = field(NumberKind.INT, "samples", number -> show(quality.withSamples(number.intValue())));
        error = field(NumberKind.DOUBLE, "targetError", number -> show(quality.withTargetError(number.doubleValue())));
        show(quality);
        panel.add(refused.component(), "span, growx, w 160");
    }

    private NumberField field(NumberKind kind, String property, Consumer<Number> taker) {
        String name = Wording.label(property);
        String meaning = Wording.meaning(RenderSettings.class, property);
        NumberField field = new NumberField(kind, property, name, meaning, refused, taker);
        Rows.add(panel, name, field.field(), "");
        return field;
    }

    private void show(RenderSettings other) {
        quality = other;
        samples.show(other.samples());
        error.show(other.targetError());
    }

    /** The studio with the size and the quality that were asked for. */
    Studio studio() {
        RenderSettings sized = size.studio().settings();
        return size.studio().withSettings(quality.withSize(sized.width(), sized.height()));
    }
}
