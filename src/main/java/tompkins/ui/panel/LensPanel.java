package tompkins.ui.panel;

import java.util.function.Consumer;
import javax.swing.JToggleButton;
import tompkins.camera.FieldOfView;
import tompkins.camera.FocusDistance;
import tompkins.camera.ThinLensCamera;
import tompkins.property.NumberText;
import tompkins.render.Quality;
import tompkins.studio.Studio;
import tompkins.ui.model.StudioModel;
import tompkins.ui.number.NumberRow;
import tompkins.ui.number.SceneSize;
import tompkins.ui.picture.Picture;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.NumberKind;
import tompkins.ui.widget.Numbers;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Range;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.Wording;

/** Aperture, focus, field of view, exposure, and how many samples the blur gets. */
public final class LensPanel extends Part {

    private final StudioModel model;
    private final SceneSize size = new SceneSize();
    private final Note note = Note.ofLines(2);
    private final JToggleButton pick = new JToggleButton(Texts.get("lens.pick"));

    /** The panel; {@code picking} is told when a point of the picture should be picked, and when no longer. */
    public LensPanel(StudioModel model, Consumer<Boolean> picking) {
        super(Rows.panel());
        this.model = model;
        Naming.name(pick, "lens.pick");
        pick.addActionListener(event -> picking.accept(pick.isSelected()));
        add(NumberRow.Quantity.ofCamera("apertureRadius", meaning("apertureRadius"), this::apertures));
        add(new NumberRow.Quantity(
                "focusDistance",
                Texts.get("lens.focusTip"),
                studio -> NumberText.rounded(FocusDistance.of(studio.camera()), 9),
                (studio, value) -> studio.withCamera(FocusDistance.with(studio.camera(), value)),
                this::distances));
        panel.add(pick, "span 3, growx");
        add(new NumberRow.Quantity(
                "horizontalAngleDegrees",
                meaning("horizontalAngleDegrees"),
                studio -> studio.camera().horizontalAngleDegrees(),
                (studio, value) -> studio.withCamera(FieldOfView.with(studio.camera(), value)),
                studio -> Range.even(1, 170)));
        add(NumberRow.Quantity.ofCamera("exposureStops", meaning("exposureStops"), (studio, now) -> Range.even(-5, 5)));
        add(
                new NumberRow.Quantity(
                        "samples",
                        Texts.get("lens.samplesTip"),
                        studio -> studio.settings().samples(),
                        (studio, value) -> studio.withSettings(studio.settings().withSamples((int) Math.rint(value))),
                        studio -> new Range(1, 256, 4)),
                NumberKind.INT);
        panel.add(note.component(), "span, growx, wmin 0");
    }

    private static String meaning(String property) {
        return Wording.meaning(ThinLensCamera.class, property);
    }

    private void add(NumberRow.Quantity quantity) {
        add(quantity, NumberKind.DOUBLE);
    }

    private void add(NumberRow.Quantity quantity, NumberKind kind) {
        new NumberRow(model, quantity, kind, note).addTo(panel);
    }

    private Range apertures(Studio studio, double now) {
        double usual = Numbers.niceCeiling(Math.max(0.05 * size.of(studio), 1e-3));
        return new Range(0, now > usual ? Numbers.niceCeiling(now) : usual, 2);
    }

    private Range distances(Studio studio) {
        double far = Numbers.niceCeiling(3 * size.of(studio));
        return new Range(far / 1000, far, 2);
    }

    /**
     * Says so if the single sample of the picture on the screen leaves a wide aperture or a long exposure without
     * effect, or if the picture has other samples than the scene says.
     */
    public void show(Picture picture) {
        boolean wished = picture.quality() instanceof Quality.TargetError;
        note.setUsual(
                picture.isTooSharp() ? Texts.get("lens.oneSample") : wished ? Texts.get("lens.otherSamples") : "");
    }

    /** Ends the picking of a point. */
    public void endPicking() {
        pick.setSelected(false);
    }
}
