package tompkins.ui.panel;

import java.awt.Component;
import java.util.ArrayList;
import java.util.List;
import javax.swing.Icon;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import tompkins.camera.Camera;
import tompkins.shutter.RollingShutter;
import tompkins.shutter.SweepDirection;
import tompkins.studio.Studio;
import tompkins.ui.model.StudioModel;
import tompkins.ui.number.NumberRow;
import tompkins.ui.number.SceneSize;
import tompkins.ui.widget.EntryField;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.NumberKind;
import tompkins.ui.widget.Numbers;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.TinyDrawing;
import tompkins.ui.widget.Updating;
import tompkins.ui.widget.Wording;

/**
 * For how long the shutter stays open, and how it rolls across the picture. Shown for shutters with an opening time;
 * for others it only says what the camera has of both, because they act there, too.
 */
final class ShutterTimingPanel extends Part {

    private final StudioModel model;
    private final SceneSize size;
    private final JPanel controls = Rows.panel();
    private final JComboBox<SweepDirection> directions = new JComboBox<>(SweepDirection.values());
    private final JLabel directionName = new JLabel(Texts.get("shutter.rolls"));
    private final List<Component> exposureRow = new ArrayList<>();
    private final Updating updating = new Updating();
    private final Note note = Note.ofLines(2);
    private boolean brief;

    ShutterTimingPanel(StudioModel model, SceneSize size) {
        super(Rows.column());
        this.model = model;
        this.size = size;
        NumberRow sweep = row(note, "rollingShutter.sweep", "shutter.sweepTip");
        Naming.items(directions, Wording::label, direction -> drawing("rolling-" + direction.name()));
        Naming.name(directions, "shutter.direction");
        directionName.setLabelFor(directions);
        directions.addActionListener(event ->
                updating.unless(() -> model.set(with(camera().withRollingShutter(new RollingShutter(
                        (SweepDirection) directions.getSelectedItem(), rolling().sweep()))))));
        sweep.addTo(controls);
        panel.add(controls, "wmin 0, hidemode 0");
        panel.add(note.component(), "wmin 0");
    }

    private static Icon drawing(String name) {
        return TinyDrawing.of(name, 20, 16, null);
    }

    /** Adds exposure time and rolling direction to rows of the opening time, for which {@code problems} are told. */
    void addTo(JPanel rows, Note problems) {
        NumberRow exposure = row(problems, "exposureTime", "shutter.exposureTip");
        exposure.setIcon(drawing("exposure"));
        int first = rows.getComponentCount();
        exposure.addTo(rows);
        exposureRow.addAll(List.of(rows.getComponents()).subList(first, rows.getComponentCount()));
        rows.add(directionName);
        rows.add(directions, "span 2, growx, wmin 0");
    }

    private NumberRow row(Note problems, String way, String tip) {
        NumberRow.Quantity span = NumberRow.Quantity.ofCamera(way, Texts.get(tip), size::spans);
        return new NumberRow(model, span, NumberKind.DOUBLE, problems);
    }

    private Camera camera() {
        return model.studio().camera();
    }

    private RollingShutter rolling() {
        return camera().rollingShutter();
    }

    private Studio with(Camera camera) {
        return model.studio().withCamera(camera);
    }

    /** Leaves out what {@link #addTo} adds, or shows it. */
    void setBrief(boolean isBrief) {
        brief = isBrief;
        exposureRow.forEach(part -> part.setVisible(!brief));
        update();
    }

    /** Shows what the studio says now. */
    void update() {
        boolean offered = camera().shutter().hasOpeningTime();
        controls.setVisible(offered);
        boolean acts = camera().exposureTime() > 0 || rolling().rolls();
        note.setUsual(
                offered || !acts
                        ? ""
                        : Texts.get(
                                "shutter.hiddenTiming",
                                Numbers.brief(camera().exposureTime()),
                                Numbers.brief(rolling().sweep())));
        if (!offered) {
            EntryField.in(controls).forEach(EntryField::revert);
            return;
        }
        updating.during(() -> directions.setSelectedItem(rolling().direction()));
        // without a sweep it says nothing
        directions.setVisible(!brief && rolling().rolls());
        directionName.setVisible(directions.isVisible());
    }
}
