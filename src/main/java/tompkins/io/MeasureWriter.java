package tompkins.io;

import java.io.StringWriter;
import java.util.List;
import tompkins.measure.Measured;
import tompkins.measure.Quantity;
import tompkins.measure.RayTable;
import tompkins.measure.Sighting;
import tools.jackson.core.JsonGenerator;

/** Writes what was measured as JSON, with 17 significant digits; numbers that are not finite are null. */
public final class MeasureWriter {

    private MeasureWriter() {}

    /** Measured numbers under their keys, each with its unit and its uncertainty; before them the shape of a conic. */
    public static String json(Measured measured) {
        StringWriter text = new StringWriter();
        try (JsonGenerator json = JsonText.generator(text)) {
            json.writeStartObject();
            if (measured.shape() != null) {
                json.writeStringProperty("shape", measured.shape().toString());
            }
            for (Quantity quantity : measured.quantities()) {
                json.writeObjectPropertyStart(quantity.key());
                write(json, "value", quantity.value());
                write(json, "uncertainty", quantity.uncertainty());
                json.writeStringProperty("unit", quantity.unit());
                json.writeEndObject();
            }
            json.writeEndObject();
        }
        return text.toString();
    }

    /** A table of rays: a list of objects with the columns of {@link RayTable} as their keys. */
    public static String jsonTable(List<Sighting> sightings) {
        StringWriter text = new StringWriter();
        try (JsonGenerator json = JsonText.generator(text)) {
            json.writeStartArray();
            for (Sighting sighting : sightings) {
                json.writeStartObject();
                for (RayTable.Column column : RayTable.COLUMNS) {
                    write(json, column.name(), column.value().apply(sighting));
                }
                json.writeEndObject();
            }
            json.writeEndArray();
        }
        return text.toString();
    }

    private static void write(JsonGenerator json, String name, Object value) {
        json.writeName(name);
        if (value instanceof Double number) {
            JsonText.write(json, number);
        } else if (value instanceof String words) {
            json.writeString(words);
        } else {
            json.writeNull();
        }
    }
}
