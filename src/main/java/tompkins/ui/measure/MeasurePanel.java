package tompkins.ui.measure;

import java.awt.BorderLayout;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import tompkins.io.FactCsv;
import tompkins.io.FactText;
import tompkins.measure.Fact;
import tompkins.measure.MeasureKind;
import tompkins.measure.Measured;
import tompkins.measure.Quantity;
import tompkins.measure.RayTable;
import tompkins.ui.widget.Buttons;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Texts;

/** What is measured in the picture, and what comes of it. */
final class MeasurePanel extends Part {

    private static final String GAP = " \u00b7 ";

    private static final Pattern IN_FRAME = Pattern.compile("(.+) \\((camera|scene|object)\\)");

    private final JComboBox<MeasureKind> kinds = new JComboBox<>(MeasureKind.values());
    private final JComboBox<ProfileChart.Content> contents = new JComboBox<>(ProfileChart.Content.values());

    /** Holds the chart, which is made for the first profile: the library behind it takes a while to come. */
    private final JPanel chartPlace = new JPanel(new BorderLayout());

    private ProfileChart chart;

    /** With room for all numbers: the picture must not move under a click that adds a point. */
    private final Note results = Note.result(4);

    private final JButton copy;
    /** What was measured in the other picture, and how sizes compare; it has its room where two are seen. */
    private final Note otherResults = Note.ofLines(2);

    private Measured measured;
    private Measured otherMeasured;

    /** The panel of a tool, hidden; {@code copier} puts a text on the clipboard. */
    MeasurePanel(MeasureTool tool, Consumer<String> copier) {
        super(new JPanel(
                new MigLayout("novisualpadding, insets 0 4 0 4, fillx, hidemode 3, gap 6 4", "[][][][grow][]")));
        Naming.name(kinds, "measure.kind");
        Naming.items(kinds, kind -> Texts.get("measure.kind." + kind.name()));
        kinds.addActionListener(event -> tool.choose(kind()));
        Naming.name(contents, "measure.chart");
        Naming.items(contents, content -> Texts.get("measure.chart." + content.name()));
        contents.addActionListener(event -> chart().setContent((ProfileChart.Content) contents.getSelectedItem()));
        chartPlace.setOpaque(false);
        copy = Buttons.of("measure.copy", () -> copier.accept(text()));
        // a narrow window has no room for the longest name
        panel.add(kinds, "wmin 0");
        panel.add(Buttons.of("measure.clear", tool::clear));
        panel.add(contents, "wmin 0");
        panel.add(copy, "skip 1, wrap");
        // the numbers beside the chart, or alone
        JPanel found = new JPanel(new MigLayout("novisualpadding, insets 0, fillx, hidemode 3"));
        found.add(chartPlace, "w 60%, wmin 0");
        found.add(results.component(), "pushx, growx, wmin 0, aligny top");
        panel.add(found, "span, growx, wmin 0, wrap");
        panel.add(otherResults.component(), "span, growx, wmin 0");
        panel.setVisible(false);
        panel.setName("measure");
        results.component().setName("measure.results");
        otherResults.component().setName("measure.other");
    }

    /** What is to be measured. */
    public MeasureKind kind() {
        return (MeasureKind) kinds.getSelectedItem();
    }

    /**
     * Shows what came of measuring; says how many places are needed where that is null.
     *
     * @param answer what came of it in the picture
     * @param otherAnswer what came of it in the picture with which that is compared
     * @param otherName name of that picture; null if there is none
     */
    public void show(MeasureTool.Answer answer, MeasureTool.Answer otherAnswer, String otherName) {
        measured = answer == null ? null : answer.measured();
        otherMeasured = otherAnswer == null ? null : otherAnswer.measured();
        boolean isProfile = measured != null && measured.profile() != null;
        chartPlace.setVisible(isProfile);
        contents.setVisible(isProfile);
        if (isProfile || chart != null) {
            chart().show(isProfile ? measured.profile() : null);
        }
        copy.setEnabled(measured != null || otherMeasured != null);
        if (answer == null) {
            results.setText(Texts.get("measure.ask." + kind().name()));
        } else if (measured == null) {
            results.setError(Texts.get("measure.problem", answer.problem()));
        } else {
            results.setText(words(measured));
        }
        showOther(otherAnswer, otherName);
        panel.revalidate();
    }

    private void showOther(MeasureTool.Answer answer, String name) {
        if (answer == null) {
            otherResults.setText(name == null ? "" : Texts.get("measure.askOther", name));
        } else if (otherMeasured == null) {
            otherResults.setError(Texts.get("measure.inOther", name, Texts.get("measure.problem", answer.problem())));
        } else {
            otherResults.setText(Texts.get(
                    "measure.inOther",
                    name,
                    measured == null ? words(otherMeasured) : compared(otherMeasured, measured)));
        }
        otherResults.component().setVisible(name != null);
    }

    private ProfileChart chart() {
        if (chart == null) {
            chart = new ProfileChart();
            Naming.name(chart, "measure.profile");
            chartPlace.add(chart);
        }
        return chart;
    }

    /** A table of a profile, or a table of the numbers; with an empty line between those of two pictures. */
    private String text() {
        return Stream.of(measured, otherMeasured)
                .filter(Objects::nonNull)
                .map(MeasurePanel::table)
                .collect(Collectors.joining("\n"));
    }

    private static String table(Measured measured) {
        Stream<String> lines = measured.profile() == null
                ? FactCsv.quantities(measured.facts())
                : FactCsv.table(RayTable.headings(), measured.profile().stream().map(RayTable::row));
        return lines.collect(Collectors.joining("\n", "", "\n"));
    }

    /**
     * All that was measured in a picture; a table has all of it, with all digits. What was measured in several frames
     * has a line, in which frames with the same number stand together.
     */
    private static String words(Measured measured) {
        if (measured.facts().isEmpty()) {
            return Texts.get("measure.noEdge");
        }
        Map<String, Map<String, String>> lines = new LinkedHashMap<>();
        Fact.forPeople(measured.facts()).forEach(fact -> {
            Matcher inFrame = IN_FRAME.matcher(FactText.SIGNS.name(fact));
            boolean frame = inFrame.matches();
            lines.computeIfAbsent(frame ? heading(inFrame.group(1), fact) + ": " : "", line -> new LinkedHashMap<>())
                    .merge(
                            frame ? value(fact) : words(fact),
                            frame ? inFrame.group(2) : "",
                            (one, other) -> one + ", " + other);
        });
        return lines.entrySet().stream()
                .map(line -> line.getValue().entrySet().stream()
                        .map(part -> part.getKey() + (part.getValue().isEmpty() ? "" : " (" + part.getValue() + ")"))
                        .collect(Collectors.joining(GAP, line.getKey(), "")))
                .collect(Collectors.joining("\n"));
    }

    /** With the unit, if none stands behind the numbers. */
    private static String heading(String name, Fact fact) {
        String unit = fact instanceof Quantity quantity ? quantity.unit() : "";
        return unit.isEmpty() || !FactText.SIGNS.unit(unit).isEmpty()
                ? name
                : Texts.get("measure.inUnit", name, unit.replace(" squared", "\u00b2"));
    }

    /** The sizes in another picture, each with how many times as large it is in this one. */
    private static String compared(Measured other, Measured measured) {
        Map<String, Quantity> ratios = measured.ratiosTo(other);
        List<String> sizes = other.quantities()
                .filter(size -> ratios.containsKey(size.key()))
                .map(size ->
                        words(size) + " " + Texts.get("measure.ratio", FactText.SIGNS.number(ratios.get(size.key()))))
                .toList();
        return sizes.isEmpty() ? words(other) : String.join(GAP, sizes);
    }

    private static String words(Fact fact) {
        return FactText.SIGNS.name(fact) + "\u00a0" + value(fact);
    }

    /** A value that does not break into lines. */
    private static String value(Fact fact) {
        return FactText.SIGNS.value(fact).replace(' ', '\u00a0');
    }
}
