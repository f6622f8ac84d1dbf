package tompkins.ui.panel;

import com.formdev.flatlaf.FlatClientProperties;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import net.miginfocom.swing.MigLayout;
import tompkins.property.NumberText;
import tompkins.studio.Studio;
import tompkins.ui.model.StudioModel;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Numbers;
import tompkins.ui.widget.Range;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.ValueSlider;

/** The bar of a ride: it begins and pauses it, records, replays and exports it, and says how fast light is. */
public final class RidePanel {

    /** How far light goes in a second, in scene units. */
    private static final double SLOWEST = 0.05;

    private static final double FASTEST = 50;

    private final StudioModel model;
    private final RidePilot pilot;
    private final JPanel panel = new JPanel(new MigLayout(
            "novisualpadding, insets 6 10 6 10, fillx, hidemode 3, gap 6 4", "[pref!]12[pref!][grow,fill][]12[pref!]"));
    private final JToggleButton ride = new JToggleButton();
    private final JToggleButton record = new JToggleButton(Texts.get("ride.record"));
    private final JButton replay = new JButton(Texts.get("ride.replay"));
    private final JButton export = new JButton(Texts.get("ride.export"));
    private final JLabel units = new JLabel();
    private final Note note = new Note("");

    /**
     * The bar.
     *
     * @param flown told that keys are wanted for the ride
     * @param exporter asks where to save the film of the ride that begins with a studio
     */
    public RidePanel(StudioModel model, RidePilot pilot, Runnable flown, Consumer<Studio> exporter) {
        this.model = model;
        this.pilot = pilot;
        ValueSlider slider = new ValueSlider(
                Texts.get("ride.light"),
                Texts.get("ride.lightTip"),
                new Range(SLOWEST, FASTEST, 3),
                (units, drag) -> setUnits(units),
                drag -> {});
        slider.show(pilot.unitsPerSecond());
        Naming.name(ride, "ride.ride");
        ride.addActionListener(event -> {
            pilot.setRiding(ride.isSelected());
            flown.run();
        });
        Naming.name(record, "ride.record");
        record.addActionListener(event -> {
            pilot.setRecording(record.isSelected());
            flown.run();
        });
        Naming.name(replay, "ride.replay");
        replay.addActionListener(event -> pilot.replay());
        Naming.name(export, "ride.export");
        export.addActionListener(event -> export(exporter));
        JButton close = new JButton("\u00d7");
        close.putClientProperty(FlatClientProperties.BUTTON_TYPE, FlatClientProperties.BUTTON_TYPE_TOOLBAR_BUTTON);
        Naming.name(close, "ride.close");
        close.addActionListener(event -> setShown(false));
        JLabel light = new JLabel(Texts.get("ride.light"));
        light.setLabelFor(slider.slider());
        panel.add(ride);
        panel.add(light);
        panel.add(slider.slider(), "wmin 60");
        panel.add(units);
        panel.add(close, "wrap");
        // in a row of their own, for a narrow window
        panel.add(record, "span, split 3");
        panel.add(replay);
        panel.add(export, "wrap");
        panel.add(new Note(Texts.get("ride.keys")).component(), "span, growx, wmin 0");
        panel.add(note.component(), "span, growx, wmin 0");
        panel.setVisible(false);
        setUnits(pilot.unitsPerSecond());
        pilot.addListener(this::update);
        model.addListener(this::updateButtons);
        update();
    }

    /** The bar itself, invisible until it is shown. */
    public JComponent component() {
        return panel;
    }

    /** Shows the bar, or hides it and pauses. */
    public void setShown(boolean shown) {
        panel.setVisible(shown);
        if (!shown) {
            pilot.setRiding(false);
        }
    }

    /** Whether the bar is shown. */
    public boolean isShown() {
        return panel.isVisible();
    }

    private void setUnits(double exact) {
        double rounded = NumberText.rounded(exact, 2);
        pilot.setUnitsPerSecond(rounded);
        units.setText(Texts.get("ride.units", Numbers.brief(rounded)));
    }

    private void update() {
        boolean riding = pilot.isRiding();
        ride.setSelected(riding);
        ride.setText(Texts.get(riding ? "ride.pause" : "ride.ride"));
        record.setSelected(pilot.isRecording());
        record.setText(Texts.get(pilot.isRecording() ? "ride.stopRecording" : "ride.record"));
        updateButtons();
    }

    private void updateButtons() {
        boolean recorded = !model.studio().ride().isEmpty();
        replay.setEnabled(pilot.canReplay() && !pilot.isRecording());
        export.setEnabled(recorded && !pilot.isRecording());
    }

    private void export(Consumer<Studio> exporter) {
        pilot.setRiding(false);
        Studio studio = model.studio();
        // a ride that leads too far is refused before a file is chosen
        note.attempt(() -> exporter.accept(studio));
    }
}
