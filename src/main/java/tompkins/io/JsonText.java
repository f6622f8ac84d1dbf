package tompkins.io;

import java.io.StringWriter;
import java.math.BigDecimal;
import java.math.MathContext;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;
import tools.jackson.core.json.JsonFactory;
import tools.jackson.core.util.DefaultPrettyPrinter;

/** JSON for other programs to check: numbers have 17 significant digits, and those that are not finite are null. */
final class JsonText {

    private static final MathContext DIGITS = new MathContext(17);

    private JsonText() {}

    /** Writes indented text. */
    static JsonGenerator generator(StringWriter text) {
        ObjectWriteContext pretty = new ObjectWriteContext.Base() {
            @Override
            public DefaultPrettyPrinter getPrettyPrinter() {
                return new DefaultPrettyPrinter();
            }
        };
        return new JsonFactory().createGenerator(pretty, text);
    }

    /** Writes a number. */
    static void write(JsonGenerator json, double value) {
        if (Double.isFinite(value)) {
            json.writeNumber(digits(value));
        } else {
            json.writeNull();
        }
    }

    /** A finite number with 17 significant digits. */
    static String digits(double value) {
        return new BigDecimal(value).round(DIGITS).toString();
    }
}
