package tompkins.ui.exchange;

import com.formdev.flatlaf.FlatClientProperties;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JPanel;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.NumberField;
import tompkins.ui.widget.NumberKind;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.Wording;

/**
 * Asks how large a photograph should be, as the scene says or some times as large as it is on the screen, and how good:
 * the samples of each pixel, or the error until which they are taken.
 */
final class PhotographOptions extends Part {

    /** Stands for the size of the scene. */
    private static final int OWN = 0;

    private final Note refused = Note.ofLines(3);
    private final PictureSize size;
    private final NumberField samples;
    private final NumberField error;
    private RenderSettings quality;

    /** Proposes the size of a studio, whose picture has a width on the screen. */
    PhotographOptions(Studio studio, int screenWidth) {
        super(Rows.of("wrap 2, hidemode 3, gap 8 5", "[][grow,fill]"));
        size = new PictureSize(studio, refused, () -> {});
        panel.setBorder(BorderFactory.createEmptyBorder(0, 12, 0, 0));
        List<Integer> sizes = List.of(OWN, 1, 2, 4);
        JPanel row = Rows.of("gap 2", "[grow,fill]".repeat(sizes.size()));
        sizes.forEach(
                times -> row.add(button(times, times == OWN ? studio.settings().width() : times * screenWidth)));
        panel.add(row, "span, growx");
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

    /** Proposes a width, also once more after another one was typed. */
    private JButton button(int times, int width) {
        JButton button = new JButton(times == OWN ? Texts.get("photograph.own") : Texts.get("photograph.times", times));
        String name = times == OWN ? Texts.get("photograph.ownName") : Texts.get("photograph.timesName", times);
        Naming.name(button, name, name);
        button.putClientProperty(FlatClientProperties.STYLE, "margin: 2,4,2,4; minimumWidth: 0");
        button.addActionListener(event -> refused.attempt(() -> size.setWidth(width)));
        return button;
    }

    /** The studio with the size and the quality that were asked for. */
    Studio studio() {
        RenderSettings sized = size.studio().settings();
        return size.studio().withSettings(quality.withSize(sized.width(), sized.height()));
    }
}
