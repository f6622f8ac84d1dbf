package tompkins.ui.widget;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Container;
import javax.swing.JTextField;
import org.joml.Vector3i;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.property.Descriptions;
import tompkins.sceneobject.CylinderLattice;
import tompkins.sceneobject.Sphere;
import tompkins.studio.RenderSettings;
import tompkins.ui.Components;
import tompkins.ui.LightLook;
import tompkins.ui.editor.RecordForm;

/** Fields for numbers, in forms and in the panel, used with the keys. */
@LightLook
class NumberFieldTest {

    private RenderSettings settings = RenderSettings.DEFAULT.withSamples(4);
    private final RecordForm form = new RecordForm(RenderSettings.class, component -> true, this::take);
    private final Container panel = (Container) form.component();

    private void take(Object changed) {
        settings = (RenderSettings) changed;
        form.show(changed);
    }

    private JTextField shown(String label) {
        form.show(settings);
        return Components.find(panel, JTextField.class, label);
    }

    @Test
    void keysChangeWholeNumbersByOneAndByTen() {
        JTextField samples = shown("Samples");
        Components.press(samples, "UP");
        assertThat(settings.samples()).isEqualTo(5);
        Components.press(samples, "shift UP");
        assertThat(settings.samples()).isEqualTo(15);
        Components.press(samples, "DOWN");
        Components.press(samples, "shift DOWN");
        assertThat(settings.samples()).isEqualTo(4);
        assertThat(samples.getText()).isEqualTo("4");
        assertThat(Components.isMarked(samples)).isFalse();
    }

    @Test
    void keysChangeTheThirdDigitOfOtherNumbers() {
        double[] radius = {0};
        RecordForm sphere =
                new RecordForm(Sphere.class, component -> true, changed -> radius[0] = ((Sphere) changed).radius());
        sphere.show(Descriptions.with(Sphere.DEFAULT, "radius", 4.0));
        JTextField field = Components.find((Container) sphere.component(), JTextField.class, "Radius");
        Components.press(field, "UP");
        assertThat(radius[0]).isEqualTo(4.01);
        sphere.show(Descriptions.with(Sphere.DEFAULT, "radius", 123456.0));
        Components.press(field, "shift DOWN");
        assertThat(radius[0]).isEqualTo(113456);
    }

    /** What came out of a computation is read, what was typed stays as it is. */
    @Test
    void aNumberThatNobodyTypedHasFourDigits() {
        Sphere[] taken = {Sphere.DEFAULT};
        RecordForm sphere = new RecordForm(Sphere.class, component -> true, changed -> taken[0] = (Sphere) changed);
        JTextField field = Components.find((Container) sphere.component(), JTextField.class, "Radius");
        sphere.show(Descriptions.with(Sphere.DEFAULT, "radius", 20.03066570511592));
        assertThat(field.getText()).isEqualTo("20.03");
        sphere.show(Descriptions.with(Sphere.DEFAULT, "radius", 20.03067));
        assertThat(field.getText()).isEqualTo("20.03067");
        Components.enter((Container) sphere.component(), "Radius", "0.123456789");
        assertThat(taken[0].radius()).isEqualTo(0.123456789);
        sphere.show(taken[0]);
        assertThat(field.getText()).isEqualTo("0.1234568");
        sphere.show(Descriptions.with(Sphere.DEFAULT, "radius", 20.03066570511592));
        Components.press(field, "UP");
        assertThat(taken[0].radius()).isEqualTo(20.13);
    }

    @Test
    void keysGoOnFromWhatWasTyped() {
        JTextField samples = shown("Samples");
        samples.setText("50");
        Components.press(samples, "UP");
        assertThat(settings.samples()).isEqualTo(51);
        samples.setText("1");
        Components.press(samples, "DOWN");
        assertThat(Components.isMarked(samples)).isTrue();
        Components.press(samples, "UP");
        assertThat(settings.samples()).isEqualTo(1);
        samples.setText("many");
        Components.press(samples, "UP");
        assertThat(samples.getText()).isEqualTo("many");
        assertThat(Components.isMarked(samples)).isTrue();
    }

    @Test
    void wholeNumbersKeepAllTheirDigits() {
        settings = settings.withSeed(123_456_789);
        JTextField seed = shown("Seed");
        assertThat(seed.getText()).isEqualTo("123456789");
        Components.press(seed, "UP");
        assertThat(settings.seed()).isEqualTo(123_456_790);
        // one more than a floating-point number can hold
        Components.enter(panel, "Seed", "9007199254740993");
        assertThat(settings.seed()).isEqualTo(0x20_0000_0000_0001L);
        Components.enter(panel, "Seed", "-9223372036854775808");
        assertThat(settings.seed()).isEqualTo(Long.MIN_VALUE);
        assertThat(seed.getText()).isEqualTo("-9223372036854775808");
    }

    @Test
    void noKeyLeadsBeyondTheRange() {
        settings = settings.withSeed(Long.MAX_VALUE);
        JTextField seed = shown("Seed");
        Components.press(seed, "UP");
        assertThat(settings.seed()).isEqualTo(Long.MAX_VALUE);
        assertThat(Components.isMarked(seed)).isTrue();
    }

    /** What a screen reader says of a field. */
    @Test
    void aRefusalDescribesTheFieldUntilTheValueIsPutRight() {
        JTextField samples = shown("Samples");
        String before = samples.getAccessibleContext().getAccessibleDescription();
        assertThat(before).isNotEmpty();
        Components.enter(panel, "Samples", "many");
        assertThat(samples.getAccessibleContext().getAccessibleDescription()).contains("must be a whole number");
        Components.enter(panel, "Samples", "3");
        assertThat(samples.getAccessibleContext().getAccessibleDescription()).isEqualTo(before);
    }

    @ParameterizedTest
    @CsvSource({"1e3, 1000", "640.0, 640", "' 7 ', 7", "+8, 8"})
    void wholeNumbersCanBeWrittenInOtherWays(String text, int width) {
        Components.enter(panel, shown("Width").getName(), text);
        assertThat(settings.width()).isEqualTo(width);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "Samples | 6.3 | Samples must be a whole number, was 6.3",
                "Samples | 1e-400 | Samples must be a whole number, was 1e-400",
                "Samples | many | Samples must be a whole number, was \"many\"",
                "Samples | 0 | Samples must be a whole number from 1 to 1048576, was 0",
                "Samples | 3e9 | Samples must be a whole number from -2147483648 to 2147483647, was 3e9",
                "Samples | 1e999999999 | Samples must be a whole number from -2147483648 to 2147483647, was 1e999999999",
                "Seed | 9223372036854775808 | Seed must be a whole number from -9223372036854775808 to"
                        + " 9223372036854775807, was 9223372036854775808"
            })
    void whatIsNoWholeNumberIsRefused(String label, String text, String message) {
        shown(label);
        RenderSettings before = settings;
        assertThat(Components.isMarked(Components.enter(panel, label, text))).isTrue();
        assertThat(Components.notes(panel)).contains("\u26a0 " + message);
        assertThat(settings).isSameAs(before);
    }

    @Test
    void numbersOfPointsAreWhole() {
        CylinderLattice[] lattice = {CylinderLattice.DEFAULT};
        RecordForm points = new RecordForm(
                CylinderLattice.class, component -> true, changed -> lattice[0] = (CylinderLattice) changed);
        Container fields = (Container) points.component();
        points.show(Descriptions.with(lattice[0], "points", new Vector3i(2, 3, 4)));
        Components.press(Components.find(fields, JTextField.class, "Points y"), "UP");
        assertThat(lattice[0].points()).isEqualTo(new Vector3i(2, 4, 4));
        JTextField z = Components.enter(fields, "Points z", "2.5");
        assertThat(Components.isMarked(z)).isTrue();
        assertThat(Components.notes(fields)).contains("\u26a0 Points (z) must be a whole number, was 2.5");
    }
}
