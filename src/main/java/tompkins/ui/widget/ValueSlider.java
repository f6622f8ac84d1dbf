package tompkins.ui.widget;

import java.util.function.BiConsumer;
import javax.swing.JSlider;

/** A slider for a value; all moves of one drag are one gesture. */
public final class ValueSlider {

    private static final int STEPS = 1000;

    private final JSlider slider = new JSlider(0, STEPS, 0);
    private final Object gesture = new Object();
    private final Updating updating = new Updating();
    private Range range;

    /** Where the knob was when it was shown or told last: a slider tells of a hand that only touches it, too. */
    private int position;

    /**
     * A slider.
     *
     * @param moved takes the value and the gesture it belongs to
     * @param released called when the hand lets go
     */
    public ValueSlider(String name, String tip, Range range, BiConsumer<Double, Object> moved, Runnable released) {
        this.range = range;
        Naming.name(slider, name, tip);
        slider.addChangeListener(event -> updating.unless(() -> {
            if (slider.getValue() != position) {
                position = slider.getValue();
                moved.accept(this.range.value((double) position / STEPS), gesture);
            }
            if (!slider.getValueIsAdjusting()) {
                released.run();
            }
        }));
    }

    /** The slider itself, to be put into a panel. */
    public JSlider slider() {
        return slider;
    }

    /** Other values at the ends; not while the hand moves the slider. */
    public void setRange(Range other) {
        if (!slider.getValueIsAdjusting()) {
            range = other;
        }
    }

    /** Shows a value, without telling anybody. */
    public void show(double value) {
        if (!slider.getValueIsAdjusting()) {
            position = (int) Math.round(range.place(value) * STEPS);
            updating.during(() -> slider.setValue(position));
        }
    }
}
