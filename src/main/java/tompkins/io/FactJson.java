package tompkins.io;

import java.io.StringWriter;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Iterator;
import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;
import tompkins.measure.Fact;
import tompkins.measure.Quantity;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;
import tools.jackson.core.json.JsonFactory;
import tools.jackson.core.util.DefaultPrettyPrinter;

/** Facts as JSON for other programs: numbers with 17 significant digits; those that are not finite are null. */
public final class FactJson {

    private static final MathContext DIGITS = new MathContext(17);

    private static final ObjectWriteContext INDENTED = new ObjectWriteContext.Base() {
        @Override
        public DefaultPrettyPrinter getPrettyPrinter() {
            return new DefaultPrettyPrinter();
        }
    };

    private final StringWriter text = new StringWriter();
    private final JsonGenerator json = new JsonFactory().createGenerator(INDENTED, text);

    private FactJson() {}

    /** An object with the values of facts under their keys; null if there are none. */
    public static String values(List<Fact> facts) {
        FactJson writer = new FactJson();
        if (Fact.forPrograms(facts).findAny().isPresent()) {
            writer.writeObject(facts);
        } else {
            writer.json.writeNull();
        }
        return writer.end();
    }

    /** As {@link #values}, but each number is an object of its own, with its unit and its uncertainty. */
    public static String measured(List<Fact> facts) {
        FactJson writer = new FactJson();
        writer.json.writeStartObject();
        Fact.forPrograms(facts).forEach(writer::writeMeasured);
        writer.json.writeEndObject();
        return writer.end();
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

    /** A finite number with 17 significant digits. */
    static String digits(double value) {
        return new BigDecimal(value).round(DIGITS).toString();
    }

    private String end() {
        json.close();
        return text.toString();
    }

    private void writeObject(List<Fact> facts) {
        json.writeStartObject();
        Fact.forPrograms(facts).forEach(fact -> {
            json.writeName(fact.key());
            writeValue(fact);
        });
        json.writeEndObject();
    }

    private void writeMeasured(Fact fact) {
        json.writeName(fact.key());
        if (fact instanceof Quantity quantity) {
            json.writeStartObject();
            json.writeName("value");
            write(quantity.value());
            json.writeName("uncertainty");
            write(quantity.uncertainty());
            json.writeStringProperty("unit", quantity.unit());
            json.writeEndObject();
        } else {
            writeValue(fact);
        }
    }

    private void writeValue(Fact fact) {
        if (fact instanceof Quantity quantity) {
            write(quantity.value());
        } else if (fact instanceof Fact.Vector vector) {
            json.writeStartArray();
            vector.values().forEach(this::write);
            json.writeEndArray();
        } else if (fact instanceof Fact.Word word) {
            json.writeString(word.text());
        } else if (fact instanceof Fact.Flag flag) {
            json.writeBoolean(flag.value());
        } else if (fact instanceof Fact.Group group) {
            writeObject(group.facts());
        } else if (fact instanceof Fact.Items items) {
            json.writeStartArray();
            Fact.forPrograms(items.groups()).forEach(this::writeValue);
            json.writeEndArray();
        }
    }

    private void write(double value) {
        if (Double.isFinite(value)) {
            json.writeNumber(digits(value));
        } else {
            json.writeNull();
        }
    }
}
