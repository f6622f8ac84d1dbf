package tompkins.ui.panel;

import java.util.function.Consumer;
import java.util.function.DoubleFunction;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import tompkins.camera.Camera;
import tompkins.camera.FieldOfView;
import tompkins.camera.FocusDistance;
import tompkins.camera.ThinLensCamera;
import tompkins.property.Descriptions;
import tompkins.property.NumberText;
import tompkins.render.Quality;
import tompkins.studio.Studio;
import tompkins.ui.model.StudioModel;
import tompkins.ui.picture.Picture;
import tompkins.ui.widget.MessageRoom;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.NumberKind;
import tompkins.ui.widget.Numbers;
import tompkins.ui.widget.Range;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.Wording;

/** Aperture, focus, field of view, exposure, and how many samples the blur gets. */
public final class LensPanel {

    private final StudioModel model;
    private final SceneSize size = new SceneSize();
    private final JPanel panel = Rows.panel();
    private final NumberRow aperture;
    private final NumberRow focus;
    private final NumberRow samples;
    private final Note refused = new Note("");
    private final Note samplesNote = new Note("");
    private final JToggleButton pick = new JToggleButton(Texts.get("lens.pick"));

    /** The panel; {@code picking} is told when a point of the picture should be picked, and when no longer. */
    public LensPanel(StudioModel model, Consumer<Boolean> picking) {
        this.model = model;
        Class<?> lens = ThinLensCamera.class;
        aperture = row(
                "apertureRadius",
                apertures(),
                Wording.meaning(lens, "apertureRadius"),
                value -> camera("apertureRadius", value));
        focus = new NumberRow(
                model,
                "focusDistance",
                NumberKind.DOUBLE,
                Texts.get("lens.focusTip"),
                distances(),
                refused,
                value -> model.studio()
                        .withCamera(FocusDistance.with(model.studio().camera(), value)));
        NumberRow field = row(
                "horizontalAngleDegrees",
                Range.even(1, 170),
                Wording.meaning(lens, "horizontalAngleDegrees"),
                value -> model.studio()
                        .withCamera(FieldOfView.with(model.studio().camera(), value)));
        NumberRow exposure = row(
                "exposureStops",
                Range.even(-5, 5),
                Wording.meaning(lens, "exposureStops"),
                value -> camera("exposureStops", value));
        samples = new NumberRow(
                model,
                "samples",
                NumberKind.INT,
                Texts.get("lens.samplesTip"),
                new Range(1, 256, 4),
                refused,
                value -> model.studio().withSettings(model.studio().settings().withSamples((int) Math.rint(value))));
        Naming.name(pick, Texts.get("lens.pick"), Texts.get("lens.pickTip"));
        pick.addActionListener(event -> picking.accept(pick.isSelected()));
        aperture.addTo(panel);
        focus.addTo(panel);
        panel.add(pick, "span 3, growx");
        field.addTo(panel);
        exposure.addTo(panel);
        samples.addTo(panel);
        panel.add(new MessageRoom(2, refused, samplesNote).component(), "span, growx, wmin 0");
        model.addListener(() -> update(field, exposure));
        update(field, exposure);
    }

    private NumberRow row(String property, Range range, String tip, DoubleFunction<Studio> change) {
        return new NumberRow(model, property, NumberKind.DOUBLE, tip, range, refused, change);
    }

    private Studio camera(String property, double value) {
        return model.studio().withCamera(Descriptions.with(model.studio().camera(), property, value));
    }

    private Range apertures() {
        return new Range(0, Numbers.niceCeiling(Math.max(0.05 * size.of(model.studio()), 1e-3)), 2);
    }

    private Range distances() {
        double far = Numbers.niceCeiling(3 * size.of(model.studio()));
        return new Range(far / 1000, far, 2);
    }

    /** The panel itself. */
    public JComponent component() {
        return panel;
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

    private void update(NumberRow field, NumberRow exposure) {
        Studio studio = model.studio();
        Camera camera = studio.camera();
        boolean hasLens = camera instanceof ThinLensCamera;
        aperture.setEnabled(hasLens);
        if (camera instanceof ThinLensCamera lens) {
            aperture.setRange(
                    lens.apertureRadius() > apertures().maximum()
                            ? new Range(0, Numbers.niceCeiling(lens.apertureRadius()), 2)
                            : apertures());
            aperture.show(lens.apertureRadius());
        } else {
            aperture.show(0);
        }
        focus.setRange(distances());
        focus.show(NumberText.rounded(FocusDistance.of(camera), 9));
        field.show(camera.horizontalAngleDegrees());
        exposure.show(camera.exposureStops());
        samples.show(studio.settings().samples());
    }
}
