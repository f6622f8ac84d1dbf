package tompkins.ui.panel;

import com.formdev.flatlaf.FlatClientProperties;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import tompkins.io.CsvText;
import tompkins.measure.MeasureKind;
import tompkins.measure.Measured;
import tompkins.measure.Quantity;
import tompkins.property.NumberText;
import tompkins.ui.picture.MeasureProbe;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Texts;

/** What is measured in the picture, and what comes of it. */
public final class MeasurePanel {

    /** What the panel asks for. */
    public interface Commands {

        /** Another kind was chosen. */
        void choose(MeasureKind kind);

        /** All places are to be forgotten. */
        void clear();

        /** A text is to be put on the clipboard. */
        void copy(String text);

        /** Measuring is to end. */
        void close();
    }

    private static final int DIGITS = 5;

    private final JPanel panel = new JPanel(
            new MigLayout("novisualpadding, insets 6 10 6 10, fillx, hidemode 3, gap 6 4", "[][][][grow][][]"));
    private final JComboBox<MeasureKind> kinds = new JComboBox<>(MeasureKind.values());
    private final JComboBox<ProfileChart.Content> contents = new JComboBox<>(ProfileChart.Content.values());
    private final ProfileChart chart = new ProfileChart();
    /** With room for all numbers of a circle: the picture must not move under a click that adds a point. */
    private final Note results = Note.ofLines(2);

    private final JButton copy;
    private Measured measured;

    /** A panel that is hidden. */
    public MeasurePanel(Commands commands) {
        Naming.name(kinds, "measure.kind");
        Naming.items(kinds, kind -> Texts.get("measure.kind." + kind.name()));
        kinds.addActionListener(event -> commands.choose(kind()));
        Naming.name(contents, "measure.chart");
        Naming.items(contents, content -> Texts.get("measure.chart." + content.name()));
        contents.addActionListener(event -> chart.setContent((ProfileChart.Content) contents.getSelectedItem()));
        Naming.name(chart, "measure.profile");
        copy = button("measure.copy", () -> commands.copy(text()));
        JButton close = button("measure.close", commands::close);
        close.setText("\u00d7");
        close.putClientProperty(FlatClientProperties.BUTTON_TYPE, FlatClientProperties.BUTTON_TYPE_TOOLBAR_BUTTON);
        // a narrow window has no room for the longest name
        panel.add(kinds, "wmin 0");
        panel.add(button("measure.clear", commands::clear));
        panel.add(contents, "wmin 0");
        panel.add(copy, "skip 1");
        panel.add(close, "wrap");
        panel.add(chart, "span, growx, wmin 0, wrap");
        panel.add(results.component(), "span, growx, wmin 0");
        panel.setVisible(false);
        panel.setName("measure");
        results.component().setName("measure.results");
    }

    private static JButton button(String key, Runnable action) {
        JButton button = new JButton(Texts.get(key));
        Naming.name(button, key);
        button.addActionListener(event -> action.run());
        return button;
    }

    /** Where it is shown. */
    public JComponent component() {
        return panel;
    }

    /** What is to be measured. */
    public MeasureKind kind() {
        return (MeasureKind) kinds.getSelectedItem();
    }

    /** Shows what came of measuring; says how many places are needed if that is null. */
    public void show(MeasureProbe.Answer answer) {
        measured = answer == null ? null : answer.measured();
        boolean isProfile = measured != null && measured.profile() != null;
        chart.setVisible(isProfile);
        contents.setVisible(isProfile);
        chart.show(isProfile ? measured.profile() : null);
        copy.setEnabled(measured != null);
        if (measured != null) {
            results.setText(words().collect(Collectors.joining("   ")));
        } else if (answer != null) {
            results.setError(Texts.get("measure.problem", answer.problem()));
        } else {
            results.setText(Texts.get("measure.ask." + kind().name()));
        }
        panel.revalidate();
    }

    private Stream<String> words() {
        List<Quantity> quantities = measured.quantities();
        return quantities.isEmpty()
                ? Stream.of(Texts.get("measure.noEdge"))
                : quantities.stream().map(MeasurePanel::words);
    }

    private static String words(Quantity quantity) {
        String value = Double.isFinite(quantity.value()) ? NumberText.of(quantity.rounded(DIGITS)) : "\u2013";
        String uncertainty = Double.isFinite(quantity.uncertainty())
                ? " \u00b1 " + NumberText.of(NumberText.rounded(quantity.uncertainty(), 2))
                : "";
        String unit = quantity.unit().isEmpty() ? "" : " " + quantity.unit();
        return Texts.get("measure." + quantity.key()) + "\u00a0" + value + uncertainty + unit;
    }

    /** A table of a profile, or a table of the numbers. */
    private String text() {
        Stream<String> lines = measured.profile() == null
                ? CsvText.quantities(measured.quantities())
                : Stream.concat(
                        Stream.of(CsvText.rayHeadings()),
                        measured.profile().places().stream().map(CsvText::rayRow));
        return lines.collect(Collectors.joining("\n", "", "\n"));
    }
}
