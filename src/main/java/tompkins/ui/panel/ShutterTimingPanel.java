package tompkins.ui.panel;

import java.awt.Component;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.ListCellRenderer;
import tompkins.camera.Camera;
import tompkins.shutter.RollingShutter;
import tompkins.shutter.SweepDirection;
import tompkins.studio.Studio;
import tompkins.ui.model.StudioModel;
import tompkins.ui.widget.EntryField;
import tompkins.ui.widget.MessageRoom;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.NumberKind;
import tompkins.ui.widget.Numbers;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.Updating;
import tompkins.ui.widget.Wording;

/**
 * For how long the shutter stays open, and how it rolls across the picture. Shown for shutters with an opening time;
 * for others it only says what the camera has of both, because they act there, too.
 */
final class ShutterTimingPanel {

    private final StudioModel model;
    private final SceneSize size;
    private final JPanel panel = Rows.column();
    private final JPanel controls = Rows.panel();
    private final NumberRow exposure;
    private final NumberRow sweep;
    private final JComboBox<SweepDirection> directions = new JComboBox<>(SweepDirection.values());
    private final Updating updating = new Updating();
    private final Note hidden = new Note("");
    private final Note refused = new Note("");

    ShutterTimingPanel(StudioModel model, SceneSize size) {
        this.model = model;
        this.size = size;
        exposure = new NumberRow(
                model,
                "exposureTime",
                NumberKind.DOUBLE,
                Texts.get("shutter.exposureTip"),
                size.spans(model.studio(), 0),
                refused,
                value -> with(camera().withExposureTime(value)));
        exposure.setIcon(TimingIcon.exposure());
        sweep = new NumberRow(
                model,
                "sweep",
                NumberKind.DOUBLE,
                Texts.get("shutter.sweepTip"),
                size.spans(model.studio(), 0),
                refused,
                value -> with(
                        camera().withRollingShutter(new RollingShutter(rolling().direction(), value))));
        Naming.items(directions, Wording::label);
        Naming.name(directions, "shutter.direction");
        directions.setRenderer(withIcons(directions.getRenderer()));
        directions.addActionListener(event ->
                updating.unless(() -> model.set(with(camera().withRollingShutter(new RollingShutter(
                        (SweepDirection) directions.getSelectedItem(), rolling().sweep()))))));
        exposure.addTo(controls);
        sweep.addTo(controls);
        JLabel rolls = new JLabel(Texts.get("shutter.rolls"));
        rolls.setLabelFor(directions);
        controls.add(rolls);
        controls.add(directions, "span 2, growx, wmin 0");
        panel.add(controls, "wmin 0, hidemode 0");
        panel.add(new MessageRoom(2, refused, hidden).component(), "wmin 0");
    }

    private static ListCellRenderer<SweepDirection> withIcons(ListCellRenderer<? super SweepDirection> words) {
        return (list, direction, index, selected, focused) -> {
            Component cell = words.getListCellRendererComponent(list, direction, index, selected, focused);
            if (cell instanceof JLabel label) {
                label.setIcon(direction == null ? null : TimingIcon.rolling(direction));
            }
            return cell;
        };
    }

    JComponent component() {
        return panel;
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

    /** Shows what the studio says now. */
    void update() {
        boolean offered = camera().shutter().hasOpeningTime();
        controls.setVisible(offered);
        boolean acts = camera().exposureTime() > 0 || rolling().rolls();
        hidden.setText(
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
        exposure.setRange(size.spans(model.studio(), camera().exposureTime()));
        exposure.show(camera().exposureTime());
        sweep.setRange(size.spans(model.studio(), rolling().sweep()));
        sweep.show(rolling().sweep());
        updating.during(() -> directions.setSelectedItem(rolling().direction()));
        directions.setEnabled(rolling().rolls());
    }
}
