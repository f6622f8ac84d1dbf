package tompkins.ui.widget;

import java.util.function.BiConsumer;
import java.util.function.Consumer;
import javax.accessibility.AccessibleContext;
import javax.swing.JSlider;

/** A slider for a value; all moves of one drag are one gesture. */
public final class ValueSlider {

    private static final int STEPS = 1000;

    private final JSlider slider = new Slider();
    private final Object gesture = new Object();
    private final Updating updating = new Updating();
    private Range range;

    /** Where the knob was when it was last shown or reported: a slider also reports a hand that only touches it. */
    private int position;

    /**
     * A slider.
     *
     * @param moved takes the value and the gesture it belongs to
     * @param released notified of the gesture when the hand lets go
     */
    public ValueSlider(
            String name, String tip, Range range, BiConsumer<Double, Object> moved, Consumer<Object> released) {
        this.range = range;
        Naming.name(slider, name, tip);
        slider.addChangeListener(event -> updating.unless(() -> {
            if (slider.getValue() != position) {
                position = slider.getValue();
                moved.accept(valueAt(position), gesture);
            }
            if (!slider.getValueIsAdjusting()) {
                released.accept(gesture);
            }
        }));
    }

    /** The slider itself, to be put into a panel. */
    public JSlider slider() {
        return slider;
    }

    private double valueAt(int step) {
        return range.value((double) step / STEPS);
    }

    private int stepOf(double value) {
        return (int) Math.round(range.position(value) * STEPS);
    }

    /** Sets other values at the ends, but not while a hand moves the slider. */
    public void setRange(Range other) {
        if (!slider.getValueIsAdjusting()) {
            range = other;
        }
    }

    /** Shows a value, without telling anybody. */
    public void show(double value) {
        if (!slider.getValueIsAdjusting()) {
            position = stepOf(value);
            updating.during(() -> slider.setValue(position));
        }
    }

    /** Tells a screen reader values, not steps. */
    @SuppressWarnings("serial") // never written to a stream
    private final class Slider extends JSlider {

        Slider() {
            super(0, STEPS, 0);
        }

        @Override
        public AccessibleContext getAccessibleContext() {
            if (accessibleContext == null) {
                accessibleContext = new AccessibleJSlider() {
                    @Override
                    public Number getCurrentAccessibleValue() {
                        return valueAt(getValue());
                    }

                    @Override
                    public boolean setCurrentAccessibleValue(Number value) {
                        setValue(stepOf(value.doubleValue()));
                        return true;
                    }

                    @Override
                    public Number getMinimumAccessibleValue() {
                        return range.minimum();
                    }

                    @Override
                    public Number getMaximumAccessibleValue() {
                        return range.maximum();
                    }
                };
            }
            return accessibleContext;
        }
    }
}
