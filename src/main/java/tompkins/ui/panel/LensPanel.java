package tompkins.ui.panel;

import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import javax.swing.JToggleButton;
import tompkins.camera.FieldOfView;
import tompkins.camera.FocusDistance;
import tompkins.camera.ThinLensCamera;
import tompkins.property.Descriptions;
import tompkins.property.NumberText;
import tompkins.render.Quality;
import tompkins.studio.Studio;
import tompkins.ui.model.StudioModel;
import tompkins.ui.number.NumberRow;
import tompkins.ui.number.SceneSize;
import tompkins.ui.picture.Picture;
import tompkins.ui.widget.MessageRoom;
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
    private final Note refused = new Note("");
    private final Note samplesNote = new Note("");
    private final JToggleButton pick = new JToggleButton(Texts.get("lens.pick"));

    /** The panel; {@code picking} is told when a point of the picture should be picked, and when no longer. */
    public LensPanel(StudioModel model, Consumer<Boolean> picking) {
        super(Rows.panel());
        this.model = model;
        Naming.name(pick, "lens.pick");
        pick.addActionListener(event -> picking.accept(pick.isSelected()));
        add("apertureRadius", LensPanel::aperture, LensPanel::withAperture, this::apertures);
        add(
                new NumberRow.Quantity(
                        "focusDistance",
                        Texts.get("lens.focusTip"),
                        studio -> NumberText.rounded(FocusDistance.of(studio.camera()), 9),
                        (studio, value) -> studio.withCamera(FocusDistance.with(studio.camera(), value)),
                        this::distances),
                NumberKind.DOUBLE);
        panel.add(pick, "span 3, growx");
        add(
                "horizontalAngleDegrees",
                studio -> studio.camera().horizontalAngleDegrees(),
                (studio, value) -> studio.withCamera(FieldOfView.with(studio.camera(), value)),
                studio -> Range.even(1, 170));
        add(
                "exposureStops",
                studio -> studio.camera().exposureStops(),
                (studio, value) -> studio.withCamera(Descriptions.with(studio.camera(), "exposureStops", value)),
                studio -> Range.even(-5, 5));
        add(
                new NumberRow.Quantity(
                        "samples",
                        Texts.get("lens.samplesTip"),
                        studio -> studio.settings().samples(),
                        (studio, value) -> studio.withSettings(studio.settings().withSamples((int) Math.rint(value))),
                        studio -> new Range(1, 256, 4)),
                NumberKind.INT);
        panel.add(new MessageRoom(2, refused, samplesNote).component(), "span, growx, wmin 0");
    }

    private void add(
            String property,
            ToDoubleFunction<Studio> reading,
            BiFunction<Studio, Double, Studio> change,
            Function<Studio, Range> range) {
        String tip = Wording.meaning(ThinLensCamera.class, property);
        add(new NumberRow.Quantity(property, tip, reading, change, range), NumberKind.DOUBLE);
    }

    private void add(NumberRow.Quantity quantity, NumberKind kind) {
        new NumberRow(model, quantity, kind, refused).addTo(panel);
    }

    /** NaN if the camera has no lens. */
    private static double aperture(Studio studio) {
        return studio.camera() instanceof ThinLensCamera lens ? lens.apertureRadius() : Double.NaN;
    }

    private static Studio withAperture(Studio studio, double radius) {
        return studio.withCamera(Descriptions.with(studio.camera(), "apertureRadius", radius));
    }

    private Range apertures(Studio studio) {
        double usual = Numbers.niceCeiling(Math.max(0.05 * size.of(studio), 1e-3));
        return new Range(0, aperture(studio) > usual ? Numbers.niceCeiling(aperture(studio)) : usual, 2);
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
        samplesNote.setText(
                picture.isTooSharp() ? Texts.get("lens.oneSample") : wished ? Texts.get("lens.otherSamples") : "");
    }

    /** Ends the picking of a point. */
    public void endPicking() {
        pick.setSelected(false);
    }
}
