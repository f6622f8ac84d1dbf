package tompkins.ui.panel;

import javax.swing.JComboBox;
import tompkins.camera.Stereo;
import tompkins.camera.StereoLayout;
import tompkins.studio.Studio;
import tompkins.ui.model.StudioModel;
import tompkins.ui.number.NumberRow;
import tompkins.ui.number.SceneSize;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.NumberKind;
import tompkins.ui.widget.Numbers;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Range;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.Updating;
import tompkins.ui.widget.Wording;

/** How the pictures of two eyes are shown, and how far apart the eyes are. */
public final class StereoPanel extends Part {

    private final StudioModel model;
    private final SceneSize size = new SceneSize();
    private final JComboBox<StereoLayout> layouts = new JComboBox<>(StereoLayout.values());
    private final Updating updating = new Updating();
    private final Note refused = Note.ofLines(2);

    /** The panel for the camera of a model. */
    public StereoPanel(StudioModel model) {
        super(Rows.panel());
        this.model = model;
        Naming.items(layouts, Wording::label);
        Naming.name(layouts, "stereo.layout");
        layouts.addActionListener(event -> updating.unless(this::choose));
        Rows.add(panel, Texts.get("stereo.layout"), layouts, "span 2, growx, wmin 0");
        add("eyeDistance", 0.1);
        add("zeroParallaxDistance", 3);
        panel.add(refused.component(), "span, growx, wmin 0");
        model.follow(this::update);
    }

    /** Adds a distance, up to a part of the size of the scene, and far enough for the number that is set. */
    private void add(String property, double part) {
        NumberRow.Quantity quantity = NumberRow.Quantity.ofCamera(
                "stereo." + property,
                Wording.meaning(Stereo.class, property),
                (studio, now) -> new Range(0, Numbers.niceCeiling(Math.max(part * size.of(studio), now)), 2));
        new NumberRow(model, quantity, NumberKind.DOUBLE, refused).addTo(panel);
    }

    private void choose() {
        Studio studio = model.studio();
        StereoLayout layout = (StereoLayout) layouts.getSelectedItem();
        refused.attempt(() -> model.set(studio.withCamera(
                studio.camera().withStereo(studio.camera().stereo().withLayout(layout)))));
        update();
    }

    private void update() {
        updating.during(
                () -> layouts.setSelectedItem(model.studio().camera().stereo().layout()));
    }
}
