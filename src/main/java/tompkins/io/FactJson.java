package tompkins.io;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Function;
import java.util.stream.Stream;
import tompkins.measure.Fact;
import tompkins.measure.Quantity;

/** Facts as JSON for other programs: numbers with 17 significant digits; those that are not finite are null. */
public final class FactJson {

    private static final MathContext DIGITS = new MathContext(17);

    private FactJson() {}

    /** An object with the values of facts under their keys; null if there are none. */
    public static String values(List<Fact> facts) {
        boolean isEmpty = Fact.forPrograms(facts).findAny().isEmpty();
        return JsonLayout.text(isEmpty ? null : object(facts, FactJson::value));
    }

    /** As {@link #values}, but each number is an object of its own, with its unit and its uncertainty. */
    public static String measured(List<Fact> facts) {
        return JsonLayout.text(object(facts, FactJson::measured));
    }

    /** The lines of a list of values; each value is asked for when its turn comes. */
    public static Stream<String> list(Stream<String> values) {
        Iterator<String> each = values.iterator();
        if (!each.hasNext()) {
            return Stream.of("[]");
        }
        return Stream.iterate(
                "[" + each.next() + (each.hasNext() ? "," : "]"),
                Objects::nonNull,
                before -> each.hasNext() ? each.next() + (each.hasNext() ? "," : "]") : null);
    }

    /** A number with 17 significant digits; null if it is not finite. */
    static BigDecimal digits(double value) {
        return Double.isFinite(value) ? new BigDecimal(value).round(DIGITS) : null;
    }

    private static Map<String, Object> object(List<Fact> facts, Function<Fact, Object> value) {
        Map<String, Object> members = new LinkedHashMap<>();
        Fact.forPrograms(facts).forEach(fact -> members.put(fact.key(), value.apply(fact)));
        return members;
    }

    private static Object measured(Fact fact) {
        if (!(fact instanceof Quantity quantity)) {
            return value(fact);
        }
        Map<String, Object> members = new LinkedHashMap<>();
        members.put("value", digits(quantity.value()));
        members.put("uncertainty", digits(quantity.uncertainty()));
        members.put("unit", quantity.unit());
        return members;
    }

    private static Object value(Fact fact) {
        if (fact instanceof Quantity quantity) {
            return digits(quantity.value());
        }
        if (fact instanceof Fact.Vector vector) {
            return vector.values().stream().map(FactJson::digits).toList();
        }
        if (fact instanceof Fact.Word word) {
            return word.text();
        }
        if (fact instanceof Fact.Flag flag) {
            return flag.value();
        }
        return fact instanceof Fact.Group group
                ? object(group.facts(), FactJson::value)
                : Fact.forPrograms(((Fact.Items) fact).groups())
                        .map(FactJson::value)
                        .toList();
    }
}
