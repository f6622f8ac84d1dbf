package tompkins.io;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import tompkins.measure.Fact;
import tompkins.measure.Quantity;
import tompkins.property.NumberText;
import tompkins.property.OneLine;

/** Facts for people to read, with no more digits than are known. */
public enum FactText {
    /** In letters that every terminal has, with the digits of numbers that were worked out. */
    EXACT(9, 9, "-", " +- ", Map.of()),
    /** The same, with the digits of numbers that were measured. */
    LETTERS(3, 5, "-", " +- ", Map.of()),
    /** With mathematical signs. */
    SIGNS(
            4,
            5,
            "\u2013",
            " \u00b1 ",
            Map.of(
                    "degrees", "\u00b0",
                    "arc minutes", "\u00a0arc\u00a0minutes",
                    "scene units", "",
                    "scene units squared", "",
                    "at distance 1", ""));

    /**
     * A line: a heading, or a fact under one.
     *
     * @param branch 0 on the main branch of a ray, more on weaker ones
     * @param isHeading whether it is a heading
     * @param name what it is
     * @param value its value; empty if there is nothing but the heading
     */
    public record Line(int branch, boolean isHeading, String name, String value) {

        /** The line with its indent; values stand in a column. */
        @Override
        public String toString() {
            String indent = "  ".repeat(branch + (isHeading ? 0 : 1));
            String plain = OneLine.of(name);
            return value.isEmpty()
                    ? indent + plain
                    : indent + String.format(Locale.ROOT, "%-29s  %s", plain, OneLine.of(value));
        }
    }

    private static final String BRANCH = "branch";

    /** Digits of a number whose uncertainty is not known. */
    private final int digits;

    /** Digits of numbers that belong together. */
    private final int vectorDigits;

    private final String missing;
    private final String plusOrMinus;
    private final Map<String, String> units;

    FactText(int digits, int vectorDigits, String missing, String plusOrMinus, Map<String, String> units) {
        this.digits = digits;
        this.vectorDigits = vectorDigits;
        this.missing = missing;
        this.plusOrMinus = plusOrMinus;
        this.units = units;
    }

    /** All facts that are told to people; those at the top are headings. */
    public Stream<Line> lines(List<Fact> facts) {
        return facts.stream()
                .flatMap(fact -> fact instanceof Fact.Items items ? items.groups().stream() : Stream.of(fact))
                .filter(fact -> !fact.name().isEmpty())
                .flatMap(this::lines);
    }

    private Stream<Line> lines(Fact fact) {
        if (!(fact instanceof Fact.Group group)) {
            return Stream.of(new Line(0, true, name(fact), value(fact)));
        }
        int branch = branch(group);
        return Stream.concat(
                Stream.of(new Line(branch, true, name(fact), "")),
                Fact.forPeople(group.facts()).map(part -> new Line(branch, false, name(part), value(part))));
    }

    private static int branch(Fact.Group group) {
        return group.facts().stream()
                .filter(fact -> fact.key().equals(BRANCH))
                .mapToInt(fact -> (int) ((Quantity) fact).value())
                .findFirst()
                .orElse(0);
    }

    /** A table of facts that have the same names in each row, with aligned columns. */
    public Stream<String> table(List<Fact> headings, List<List<Fact>> rows) {
        List<List<String>> lines = new ArrayList<>();
        lines.add(Fact.forPeople(headings).map(this::name).toList());
        rows.forEach(row -> lines.add(
                Fact.forPeople(row).map(fact -> OneLine.of(plain(fact))).toList()));
        int[] widths = new int[lines.get(0).size()];
        lines.forEach(line ->
                Arrays.setAll(widths, i -> Math.max(widths[i], line.get(i).length())));
        return lines.stream()
                .map(line -> IntStream.range(0, widths.length)
                        .mapToObj(i ->
                                line.get(i) + " ".repeat(widths[i] - line.get(i).length()))
                        .collect(Collectors.joining("  "))
                        .stripTrailing());
    }

    /** A value without its unit, which is known from the column. */
    private String plain(Fact fact) {
        return fact instanceof Quantity quantity ? number(quantity) : value(fact);
    }

    /** A formula, or a text with formulas, with the signs of printed ones; a minus stays as it is typed everywhere. */
    public static String readable(String text) {
        return text.replace("sqrt", "\u221a");
    }

    /** What a fact is called. */
    public String name(Fact fact) {
        return this == SIGNS ? fact.name().replace("^2", "\u00b2") : fact.name();
    }

    /** What follows a number in a unit, which may be empty. */
    public String unit(String unit) {
        return unit.isEmpty() ? "" : units.getOrDefault(unit, " " + unit);
    }

    /** The value of a fact, in one line; of a group, its first fact stands without its name. */
    public String value(Fact fact) {
        if (fact instanceof Quantity quantity) {
            return number(quantity) + unit(quantity.unit());
        }
        if (fact instanceof Fact.Vector vector) {
            return vector.values().stream().map(this::number).collect(Collectors.joining(", ", "(", ")"));
        }
        if (fact instanceof Fact.Word word) {
            return word.text() == null ? missing : word.text();
        }
        if (fact instanceof Fact.Flag flag) {
            return flag.value() ? "yes" : "no";
        }
        List<Fact> parts = Fact.forPeople(((Fact.Group) fact).facts()).toList();
        return parts.stream()
                .map(part -> part == parts.get(0) ? value(part) : name(part) + " " + value(part))
                .collect(Collectors.joining(", "));
    }

    /** A number with its uncertainty, without its unit. */
    public String number(Quantity quantity) {
        if (!Double.isFinite(quantity.value())) {
            return number(quantity.value());
        }
        return quantity.isUncertain()
                ? quantity.text(digits) + plusOrMinus + quantity.uncertaintyText()
                : quantity.text(digits);
    }

    private String number(double value) {
        return Double.isFinite(value) ? NumberText.of(NumberText.rounded(value, vectorDigits)) : missing;
    }
}
