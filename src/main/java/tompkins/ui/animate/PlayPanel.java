package tompkins.ui.animate;

import java.util.Objects;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import javax.swing.Timer;
import net.miginfocom.swing.MigLayout;
import tompkins.animation.Animation;
import tompkins.property.InvalidPropertyException;
import tompkins.property.NumberText;
import tompkins.property.Require;
import tompkins.spacetime.SpeedScale;
import tompkins.studio.Studio;
import tompkins.ui.model.Pace;
import tompkins.ui.model.StudioModel;
import tompkins.ui.number.NumberChoice;
import tompkins.ui.number.NumberProperty;
import tompkins.ui.number.SceneSize;
import tompkins.ui.widget.Buttons;
import tompkins.ui.widget.EntryField;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.NumberField;
import tompkins.ui.widget.NumberKind;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Range;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.Updating;
import tompkins.ui.widget.ValueSlider;
import tompkins.ui.widget.Wording;
import tompkins.world.LitSpan;

/** Runs a number of the studio between two values, with a scrubber. */
public final class PlayPanel extends Part {

    private static final int TICK_MILLISECONDS = 33;
    private static final int LIGHT_DIGITS = 6;

    private final StudioModel model;
    private final Consumer<NumberProperty> chosen;
    private final SceneSize size = new SceneSize();
    private final NumberChoice numbers = new NumberChoice(this::suggestValues);
    private final JComboBox<Animation.Course> courses = new JComboBox<>(Animation.Course.values());
    private final JToggleButton play = new JToggleButton(Texts.get("play.play"));
    private final JCheckBox loop = new JCheckBox(Texts.get("play.loop"), true);
    private final ValueSlider scrubber = new ValueSlider(
            Texts.get("play.scrubber"),
            Texts.get("play.scrubberTip"),
            Range.even(0, 1),
            (share, drag) -> moveTo(share, Pace.HAND),
            drag -> endStep());
    private final JLabel value = new JLabel();
    private final Note note = new Note("");
    private final NumberField fromField;
    private final NumberField toField;
    private final NumberField secondsField;
    private final Timer timer = new Timer(TICK_MILLISECONDS, event -> tick());
    private final Object gesture = new Object();
    private final Updating updating = new Updating();
    private double from;
    private double to;
    private double seconds;
    private double time;
    private long lastTick;

    /** The number as the animation left it. */
    private double played;

    /**
     * The panel.
     *
     * @param export takes a studio and the animation of it that is to be saved
     * @param chosen notified of the number that is to be animated; null while the panel is hidden
     */
    public PlayPanel(StudioModel model, BiConsumer<Studio, Animation> export, Consumer<NumberProperty> chosen) {
        super(new JPanel(new MigLayout(
                "novisualpadding, insets 0 4 0 4, fillx, hidemode 3, gap 6 4", "[pref!][grow,fill][pref!][pref!]")));
        this.model = model;
        this.chosen = chosen;
        fromField = field("play.from", number -> setEnds(allowed("from", number), to));
        toField = field("play.to", number -> setEnds(from, allowed("to", number)));
        secondsField = field(
                "play.seconds",
                number -> setSeconds(Require.within("seconds", number, Animation.SHORTEST, Animation.LONGEST)));
        setSeconds(4);
        Naming.name(courses, "play.course");
        courses.addActionListener(event -> follow());
        Naming.items(courses, Wording::label);
        Naming.name(play, "play.play");
        play.addActionListener(event -> setPlaying(play.isSelected()));
        Naming.name(loop, "play.loop");
        panel.add(numberRow(), "span, growx, wrap, wmin 0");
        panel.add(valuesRow(), "span, growx, wrap, wmin 0");
        panel.add(play, "wmin pref");
        panel.add(scrubber.slider(), "wmin 60");
        panel.add(value, "wmin 80");
        panel.add(
                Buttons.of(
                        "play.export",
                        () -> wanted().ifPresent(animation -> {
                            setPlaying(false);
                            export.accept(model.studio(), animation);
                        })),
                "wmin pref, wrap");
        panel.add(note.component(), "span, growx, wmin 0");
        panel.setVisible(false);
        model.addListener(this::update);
    }

    private JComponent numberRow() {
        JPanel row = Rows.of("gap 6", "[grow,fill][][]");
        row.add(numbers.component(), "wmin 60");
        row.add(courses);
        row.add(loop);
        return row;
    }

    private JComponent valuesRow() {
        JPanel row =
                new JPanel(new MigLayout("novisualpadding, insets 0, gap 6", "[][50:pref]12[][50:pref]12[][50:pref]"));
        Rows.add(row, Texts.get("play.from"), fromField.field(), "growx, wmin 50");
        Rows.add(row, Texts.get("play.to"), toField.field(), "growx, wmin 50");
        Rows.add(row, Texts.get("play.seconds"), secondsField.field(), "growx, wmin 50");
        return row;
    }

    private NumberField field(String key, DoubleConsumer commit) {
        String name = Texts.get(key);
        return new NumberField(
                NumberKind.DOUBLE,
                name,
                name,
                Texts.get(key + "Tip"),
                note,
                number -> commit.accept(number.doubleValue()));
    }

    /**
     * A number with which the animation begins or ends; one that the studio refuses is marked at once, and not
     * half-way.
     */
    private double allowed(String end, double number) {
        Require.finite(end, number);
        // made only to see whether it can be
        Objects.requireNonNull(property().number().with(model.studio(), number));
        return number;
    }

    /** Shows the panel for the studio as it is, or hides it. */
    public void setShown(boolean shown) {
        panel.setVisible(shown);
        update();
        if (!shown) {
            setPlaying(false);
            EntryField.in(panel).forEach(EntryField::revert);
        }
        chosen.accept(shown ? property() : null);
    }

    private void update() {
        if (panel.isVisible()) {
            if (!numbers.show(model.studio())) {
                setPlaying(false);
                suggestValues();
            }
            updating.unless(this::follow);
        }
    }

    /** Goes to the present value of the number, unless it runs; it pauses if something else has changed it. */
    private void follow() {
        double now = present();
        if (now != played) {
            setPlaying(false);
        }
        if (!isPlaying()) {
            time = animation().time(now, time);
            showTime();
        }
    }

    private double present() {
        return property().number().in(model.studio());
    }

    /** Makes a drag of the scrubber a step of its own, unless it belongs to an animation that runs. */
    private void endStep() {
        if (!isPlaying()) {
            model.endGesture(gesture);
        }
    }

    private void showTime() {
        value.setText(property().text(model.studio()));
        scrubber.show(time);
    }

    /** Runs a number, if the studio has it. */
    public void run(NumberProperty property) {
        setShown(true);
        if (numbers.choose(property)) {
            setPlaying(true);
        } else {
            note.setError(Texts.get("play.none", property.name()));
        }
    }

    /** Runs the opening time over the times in which a flash lights something, if there are any. */
    public void runLight(Optional<LitSpan> litTimes) {
        setShown(true);
        litTimes.filter(times -> numbers.choose(NumberProperty.openingTime()))
                .ifPresentOrElse(this::runLight, () -> note.setError(Texts.get("play.noFlash")));
    }

    private void runLight(LitSpan times) {
        setEnds(NumberText.rounded(times.from(), LIGHT_DIGITS), NumberText.rounded(times.to(), LIGHT_DIGITS));
        time = 0;
        setPlaying(true);
    }

    /** Begins with values that show something. */
    private void suggestValues() {
        NumberProperty property = property();
        played = present();
        chosen.accept(property);
        EntryField.in(panel).forEach(EntryField::revert);
        suggestEnds(property);
        note.setText("");
    }

    /**
     * Speeds from rest, times through the scene, other numbers from their value to twice it, or to half of it if twice
     * is too much.
     */
    private void suggestEnds(NumberProperty property) {
        Object last = property.number().path().last();
        if (last.equals(SpeedScale.BETA.key())) {
            setEnds(0, 0.99);
        } else if (last.equals(SpeedScale.RAPIDITY.key())) {
            setEnds(0, 3);
        } else if (property.equals(NumberProperty.openingTime())) {
            Range times = size.times(model.studio());
            setEnds(times.minimum() / 2, times.maximum() / 2);
        } else {
            double twice = played == 0 ? 1 : 2 * played;
            setEnds(played, isAllowed(twice) ? twice : played / 2);
        }
    }

    private boolean isAllowed(double number) {
        try {
            allowed("to", number);
            return true;
        } catch (InvalidPropertyException refused) {
            return false;
        }
    }

    private void setEnds(double first, double last) {
        from = first;
        to = last;
        fromField.show(from);
        toField.show(to);
        updating.unless(this::follow);
    }

    private void setSeconds(double number) {
        seconds = number;
        secondsField.show(number);
    }

    private NumberProperty property() {
        return numbers.chosen();
    }

    /** The animation that a shown panel describes; none if what is typed into it is refused. */
    public Optional<Animation> wanted() {
        return EntryField.takeAll(panel) ? Optional.of(animation()) : Optional.empty();
    }

    private Animation animation() {
        return new Animation(property().number(), from, to, seconds, (Animation.Course) courses.getSelectedItem());
    }

    /** Starts or stops the animation; it does not start with a value that was refused. */
    public void setPlaying(boolean wish) {
        boolean playing = wish && EntryField.takeAll(panel);
        play.setSelected(playing);
        play.setText(Texts.get(playing ? "play.pause" : "play.play"));
        if (playing) {
            time = time >= 1 ? 0 : time;
            played = present();
            lastTick = System.nanoTime();
            timer.start();
        } else {
            timer.stop();
            model.endGesture(gesture);
        }
    }

    /** Whether the animation runs. */
    public boolean isPlaying() {
        return timer.isRunning();
    }

    private void tick() {
        long now = System.nanoTime();
        double next = time + (now - lastTick) * 1e-9 / seconds;
        lastTick = now;
        boolean over = next >= 1 && !loop.isSelected();
        moveTo(over ? 1 : next % 1, Pace.FILM);
        if (over) {
            setPlaying(false);
        }
    }

    private void moveTo(double share, Pace pace) {
        time = share;
        Animation animation = animation();
        updating.during(() -> {
            if (!note.attempt(() -> model.adjust(animation.studio(model.studio(), share), gesture, pace))) {
                setPlaying(false);
            }
        });
        played = present();
        showTime();
    }
}
