package tompkins.ui.ride;

import java.awt.Color;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.JToggleButton;
import javax.swing.UIManager;
import net.miginfocom.swing.MigLayout;
import tompkins.property.NumberText;
import tompkins.studio.Ride;
import tompkins.studio.RideMoment;
import tompkins.studio.Studio;
import tompkins.ui.editor.StudioRow;
import tompkins.ui.model.Settings;
import tompkins.ui.model.StudioModel;
import tompkins.ui.widget.Buttons;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Numbers;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Range;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.ShortLabel;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.ValueSlider;

/**
 * The bar of a ride, in one line: it begins and pauses it, leads back, offers the rides of the scene, and says what to
 * try. What is needed less often comes with a button: the speed of light, recording, replay, and the keys.
 */
public final class RidePanel extends Part {

    /** How far light goes in a second, in scene units. */
    private static final double SLOWEST = 0.05;

    private static final double FASTEST = 50;

    /** The setting of the keyboard. */
    private static final String KEYBOARD = "ride.keyboard";

    private final StudioModel model;
    private final RidePilot pilot;
    private final Runnable flown;
    private final JToggleButton ride = new JToggleButton();
    private final JToggleButton record = new JToggleButton(Texts.get("ride.record"));
    private final JButton home;
    private final JButton challenges;
    private final JButton replay;
    private final JButton export;
    private final JLabel units = new JLabel();

    /** What to try, or how to steer; then how far that is done. */
    private final JLabel task = new ShortLabel("ride.task");

    private final ValueSlider light;

    private final JComboBox<RideKeyboard> keyboard =
            new JComboBox<>(RideKeyboard.common().toArray(RideKeyboard[]::new));

    private final Consumer<RideKeyboard> steerer;
    private final Note keys = new Note("");
    private final Note note = new Note("");

    /**
     * The bar.
     *
     * @param flown notified that keys are wanted for the ride
     * @param exporter asks where to save the film of the ride that begins with a studio
     * @param steerer takes the keyboard whose letters steer
     */
    public RidePanel(
            StudioModel model,
            Settings settings,
            RidePilot pilot,
            Runnable flown,
            Consumer<Studio> exporter,
            Consumer<RideKeyboard> steerer) {
        super(new JPanel(
                new MigLayout("novisualpadding, insets 0 4 0 4, fillx, hidemode 3, gap 6 4", "[][][][grow,fill][]")));
        this.model = model;
        this.pilot = pilot;
        this.flown = flown;
        this.steerer = steerer;
        light = new ValueSlider(
                Texts.get("ride.light"),
                Texts.get("ride.lightTip"),
                new Range(SLOWEST, FASTEST, 3),
                (units, drag) -> setUnits(units),
                drag -> {});
        Naming.name(ride, "ride.ride");
        ride.addActionListener(event -> fly(() -> pilot.setRiding(ride.isSelected())));
        Naming.name(record, "ride.record");
        record.addActionListener(event -> fly(() -> pilot.setRecording(record.isSelected())));
        home = Buttons.of("ride.home", () -> fly(pilot::home));
        challenges = Buttons.of("ride.challenges", this::offerRides);
        replay = Buttons.of("ride.replay", () -> fly(pilot::replay));
        export = Buttons.of("ride.export", () -> export(exporter));
        offerKeyboards(settings);
        JComponent more = more();
        JToggleButton showMore = new JToggleButton(Texts.get("ride.more"));
        Naming.name(showMore, "ride.more");
        showMore.addActionListener(event -> more.setVisible(showMore.isSelected()));
        panel.add(ride);
        panel.add(home);
        panel.add(challenges);
        panel.add(task, "wmin 0");
        panel.add(showMore, "wrap");
        panel.add(more, "span, growx");
        panel.setVisible(false);
        pilot.addListener(this::update);
        model.addListener(this::updateTask);
        update();
    }

    private JComponent more() {
        JPanel more = Rows.of("hidemode 3, gap 6 4", "[pref!][grow,fill][]");
        Rows.add(more, Texts.get("ride.light"), light.slider(), "wmin 60");
        more.add(units, "wrap");
        more.add(record, "span, split 4");
        more.add(replay);
        more.add(export);
        JPanel views = Rows.of("wrap 2, hidemode 3, gap 6 5", "[pref][grow,fill]");
        new StudioRow(model, "view", Texts.get("row.view")).addTo(views);
        more.add(views, "gapleft push, wmin 0, wrap");
        more.add(keyboard, "span, split 2, wmin 0");
        more.add(keys.component(), "growx, wmin 0, wrap");
        more.add(note.component(), "span, growx, wmin 0");
        more.setVisible(false);
        return more;
    }

    private void fly(Runnable action) {
        action.run();
        flown.run();
    }

    /** Lists the rides of the scene: each challenge that was tried with what became of it. */
    private void offerRides() {
        JPopupMenu menu = new JPopupMenu();
        for (Ride offer : model.studio().rides()) {
            RideTask.Verdict verdict = pilot.task().verdict(offer);
            JMenuItem item = new JMenuItem();
            item.setText(verdict == null ? offer.name() : offer.name() + "   (" + verdict.text() + ")");
            item.setName(offer.name());
            if (verdict != null) {
                item.setForeground(colour(verdict));
            }
            item.addActionListener(event -> fly(() -> pilot.begin(offer)));
            menu.add(item);
        }
        menu.show(challenges, 0, challenges.getHeight());
    }

    private static Color colour(RideTask.Verdict verdict) {
        return UIManager.getColor(verdict.met() ? "Tompkins.done" : "Tompkins.error");
    }

    /** The letters of common keyboards. */
    private void offerKeyboards(Settings settings) {
        Naming.name(keyboard, "ride.keyboard");
        Naming.items(keyboard, known -> known.text() + "   " + known.name());
        keyboard.setSelectedItem(RideKeyboard.of(settings.text(KEYBOARD, "")));
        steer();
        keyboard.addActionListener(event -> settings.setText(KEYBOARD, steer().letters()));
    }

    private RideKeyboard steer() {
        RideKeyboard chosen = (RideKeyboard) keyboard.getSelectedItem();
        steerer.accept(chosen);
        keys.setText(Texts.get("ride.keys", (Object[]) chosen.text().split(" ")));
        return chosen;
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
        units.setText(Texts.get(rounded == 1 ? "ride.unit" : "ride.units", Numbers.brief(rounded)));
    }

    private void update() {
        boolean riding = pilot.isRiding();
        ride.setSelected(riding);
        ride.setText(Texts.get(riding ? "ride.pause" : "ride.ride"));
        record.setSelected(pilot.isRecording());
        record.setText(Texts.get(pilot.isRecording() ? "ride.stopRecording" : "ride.record"));
        light.show(pilot.unitsPerSecond());
        setUnits(pilot.unitsPerSecond());
        updateTask();
    }

    /** What can be done where the camera is: after an undo it may be on no ride. */
    private void updateTask() {
        RideMoment now = pilot.moment();
        RideTask.Verdict verdict = now == null ? null : pilot.task().verdict();
        String text = verdict != null ? verdict.text() : task(now);
        task.setText(text);
        task.setForeground(verdict == null ? UIManager.getColor("Label.foreground") : colour(verdict));
        home.setEnabled(now != null);
        challenges.setVisible(!model.studio().rides().isEmpty());
        boolean canReplay = pilot.canReplay() && !pilot.isRecording();
        replay.setEnabled(canReplay);
        export.setEnabled(canReplay);
    }

    /** What to try, and after the start how far that is done; without a task the keys. */
    private String task(RideMoment now) {
        if (now == null || pilot.task().text().isEmpty()) {
            return keys.text();
        }
        String progress = pilot.task().progress(now);
        return now.properTime() > 0 && !progress.isEmpty()
                ? progress
                : pilot.task().text();
    }

    private void export(Consumer<Studio> exporter) {
        pilot.setRiding(false);
        Studio studio = pilot.beginning();
        // a ride that leads too far is refused before a file is chosen
        note.attempt(() -> exporter.accept(studio));
    }
}
