package tompkins.ui.ride;

import java.awt.Dimension;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.DefaultComboBoxModel;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import net.miginfocom.swing.MigLayout;
import tompkins.property.NumberText;
import tompkins.studio.Ride;
import tompkins.studio.Studio;
import tompkins.ui.model.Settings;
import tompkins.ui.model.StudioModel;
import tompkins.ui.editor.StudioRow;
import tompkins.ui.widget.Buttons;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Numbers;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Range;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.Updating;
import tompkins.ui.widget.ValueSlider;

/** The bar of a ride: it begins and pauses it, records, replays and exports it, and says how fast light is. */
public final class RidePanel extends Part {

    /** How far light goes in a second, in scene units. */
    private static final double SLOWEST = 0.05;

    private static final double FASTEST = 50;

    /** The setting of the keyboard. */
    private static final String KEYBOARD = "ride.keyboard";

    private final RidePilot pilot;
    private final JToggleButton ride = new JToggleButton();
    private final JToggleButton record = new JToggleButton(Texts.get("ride.record"));
    private final JButton replay;
    private final JButton export;

    /** The rides that are offered. */
    private List<Ride> shown = List.of();

    private final JLabel units = new JLabel();
    private final JComboBox<Ride> rides = new JComboBox<>();
    private final Note task = new Note("");
    private final ValueSlider light;

    /** The names of keyboards have room in its list alone. */
    private final JComboBox<String> keyboard = new JComboBox<>() {
        @Override
        public Dimension getPreferredSize() {
            int height = super.getPreferredSize().height;
            return new Dimension(getFontMetrics(getFont()).stringWidth("W W W W W W W") + 2 * height, height);
        }
    };

    private final Updating updating = new Updating();
    private double told;
    private final Note keys = new Note("");
    private final JButton otherKeyboard = new JButton();
    private boolean offered;
    private final Note note = new Note("");

    /**
     * The bar.
     *
     * @param flown notified that keys are wanted for the ride
     * @param exporter asks where to save the film of the ride that begins with a studio
     */
    public RidePanel(StudioModel model, Settings settings, RidePilot pilot, Runnable flown, Consumer<Studio> exporter) {
        super(new JPanel(new MigLayout(
                "novisualpadding, insets 0 4 0 4, fillx, hidemode 3, gap 6 4", "[pref!]12[pref!][grow,fill][][]")));
        this.pilot = pilot;
        light = new ValueSlider(
                Texts.get("ride.light"),
                Texts.get("ride.lightTip"),
                new Range(SLOWEST, FASTEST, 3),
                (units, drag) -> setUnits(units),
                drag -> {});
        light.show(pilot.unitsPerSecond());
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
        replay = Buttons.of("ride.replay", () -> {
            pilot.replay();
            flown.run();
        });
        export = Buttons.of("ride.export", () -> export(exporter));
        offerKeyboards(settings, flown);
        offerRides(model, flown);
        panel.add(ride);
        Rows.add(panel, Texts.get("ride.light"), light.slider(), "wmin 60");
        panel.add(units);
        // a long name must leave room for the slider
        panel.add(rides, "wmin 0, wmax 35%");
        panel.add(record, "newline, span, split 4");
        panel.add(replay);
        panel.add(export);
        JPanel views = Rows.panel();
        new StudioRow(model, "view", Texts.get("row.view")).addTo(views);
        panel.add(views, "gapleft push, wmin pref, wrap");
        panel.add(task.component(), "span, growx, wmin 0");
        panel.add(keyboard, "span, split 3, wmin pref");
        panel.add(otherKeyboard);
        panel.add(keys.component(), "growx, wmin 0, wrap");
        panel.add(note.component(), "span, growx, wmin 0");
        panel.setVisible(false);
        setUnits(pilot.unitsPerSecond());
        pilot.addListener(this::update);
        model.addListener(this::updateTask);
        update();
    }

    private void offerRides(StudioModel model, Runnable flown) {
        Naming.name(rides, "ride.rides");
        Naming.items(rides, Ride::name);
        // arrow keys in the list only look for a ride; Enter begins it
        rides.putClientProperty("JComboBox.isTableCellEditor", true);
        Runnable update = () -> {
            List<Ride> offered = model.studio().rides();
            rides.setVisible(offered.size() > 1);
            if (!offered.equals(shown)) {
                shown = offered;
                rides.setModel(new DefaultComboBoxModel<>(offered.toArray(Ride[]::new)));
            }
        };
        rides.addActionListener(event -> updating.unless(() -> {
            pilot.begin((Ride) rides.getSelectedItem());
            flown.run();
        }));
        model.follow(update);
    }

    /** The letters of common keyboards; others can be typed. */
    private void offerKeyboards(Settings settings, Runnable flown) {
        Naming.name(keyboard, "ride.keyboard");
        List<RideKeyboard> common = RideKeyboard.common();
        common.forEach(known -> keyboard.addItem(known.text()));
        Naming.items(
                keyboard,
                text -> common.stream()
                        .filter(known -> known.text().equals(text))
                        .map(known -> text + "   " + known.name())
                        .findFirst()
                        .orElse(text));
        keyboard.setEditable(true);
        RideKeyboard kept = RideKeyboard.of(settings.text(KEYBOARD, ""));
        steerBy(kept == null ? RideKeyboard.usual() : kept);
        otherKeyboard.setName("ride.otherKeyboard");
        otherKeyboard.setVisible(false);
        otherKeyboard.addActionListener(event -> flown.run());
        keyboard.addActionListener(event -> {
            RideKeyboard chosen = RideKeyboard.of(String.valueOf(keyboard.getSelectedItem()));
            otherKeyboard.setVisible(false);
            // a text that is not seven letters is undone
            steerBy(chosen == null ? pilot.keyboard() : chosen);
            if (chosen != null) {
                settings.setText(KEYBOARD, chosen.letters());
                settings.save();
            }
        });
    }

    /** Offers, once, the keyboard on which a letter steers that does nothing on the present one. */
    void offerKeyboard(char letter) {
        pilot.keyboard().other(letter).filter(other -> !offered).ifPresent(other -> {
            offered = true;
            otherKeyboard.setText(Texts.get("ride.otherKeyboard", other.text(), other.name()));
            otherKeyboard.addActionListener(event -> keyboard.setSelectedItem(other.text()));
            otherKeyboard.setVisible(true);
        });
    }

    private void steerBy(RideKeyboard chosen) {
        pilot.setKeyboard(chosen);
        if (!chosen.text().equals(keyboard.getSelectedItem())) {
            keyboard.setSelectedItem(chosen.text());
        }
        keys.setText(Texts.get("ride.keys", (Object[]) chosen.text().split(" ")));
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
        told = rounded;
        units.setText(Texts.get(rounded == 1 ? "ride.unit" : "ride.units", Numbers.brief(rounded)));
    }

    private void update() {
        boolean riding = pilot.isRiding();
        ride.setSelected(riding);
        ride.setText(Texts.get(riding ? "ride.pause" : "ride.ride"));
        record.setSelected(pilot.isRecording());
        record.setText(Texts.get(pilot.isRecording() ? "ride.stopRecording" : "ride.record"));
        if (pilot.task().ride() != null) {
            // none while the camera flies from elsewhere
            updating.during(
                    () -> rides.setSelectedIndex(shown.indexOf(pilot.task().ride())));
        }
        if (pilot.unitsPerSecond() != told) {
            light.show(pilot.unitsPerSecond());
            setUnits(pilot.unitsPerSecond());
        }
        updateTask();
    }

    /** What can be done where the camera is: after an undo it may be on no ride. */
    private void updateTask() {
        task.setText(
                pilot.moment() == null
                        ? ""
                        : (pilot.task().text() + "\n" + pilot.task().news()).strip());
        boolean flown = pilot.canReplay() && !pilot.isRecording();
        replay.setEnabled(flown);
        export.setEnabled(flown);
    }

    private void export(Consumer<Studio> exporter) {
        pilot.setRiding(false);
        Studio studio = pilot.beginning();
        // a ride that leads too far is refused before a file is chosen
        note.attempt(() -> exporter.accept(studio));
    }
}
