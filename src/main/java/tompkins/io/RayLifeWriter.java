package tompkins.io;

import java.io.StringWriter;
import java.util.Locale;
import org.joml.Vector3dc;
import tompkins.ray.Colour;
import tompkins.spacetime.Event;
import tompkins.spacetime.SpaceTimeTransformation;
import tompkins.spacetime.SpeedScale;
import tompkins.studio.Studio;
import tompkins.trace.RayLife;
import tools.jackson.core.JsonGenerator;

/**
 * Writes the life of a ray as JSON, with 17 significant digits, for other programs to check; numbers that are not
 * finite are null.
 */
public final class RayLifeWriter {

    private RayLifeWriter() {}

    /**
     * The life of a ray in a studio as JSON. The part {@code scene} is missing if the ray never enters the scene frame.
     * Each hit is given in the frame in which it was found, then in that of the camera and that of the scene, and, if
     * its object moves by itself, in its own. The normal is that of the frame in which the object rests.
     */
    public static String json(RayLife life, Studio studio) {
        StringWriter text = new StringWriter();
        try (JsonGenerator json = JsonText.generator(text)) {
            json.writeStartObject();
            writeStart(json, "camera", life.cameraStart(), life.cameraDirection());
            if (life.sceneStart() != null) {
                writeStart(json, "scene", life.sceneStart(), life.sceneDirection());
            }
            write(json, "frequencyRatio", life.frequencyRatio());
            SpeedScale scale = studio.transformation().speedScale();
            write(json, scale.key(), scale.valueOf(studio.velocity()));
            json.writeArrayPropertyStart("hits");
            for (RayLife.Encounter hit : life.hits()) {
                writeHit(json, hit, studio.sceneFromCamera());
            }
            json.writeEndArray();
            Colour colour = life.colour();
            write(json, "colour", colour.red(), colour.green(), colour.blue());
            json.writeEndObject();
        }
        return text.toString();
    }

    private static void writeStart(JsonGenerator json, String name, Event event, Vector3dc direction) {
        json.writeObjectPropertyStart(name);
        write(json, event, "time");
        write(json, "direction", direction.x(), direction.y(), direction.z());
        json.writeEndObject();
    }

    private static void writeHit(JsonGenerator json, RayLife.Encounter hit, SpaceTimeTransformation sceneFromCamera) {
        json.writeStartObject();
        json.writeStringProperty("object", hit.object().description());
        json.writeStringProperty("frame", hit.frame().name().toLowerCase(Locale.ROOT));
        write(json, hit.event(), "time");
        write(json, "distance", hit.distance());
        write(json, "share", hit.share());
        json.writeNumberProperty("branch", hit.branch());
        json.writeStringProperty("surface", hit.surface().getClass().getSimpleName());
        Vector3dc normal = hit.rest().normal();
        write(json, "normal", normal.x(), normal.y(), normal.z());
        write(json, "surfaceCoordinates", hit.rest().u(), hit.rest().v());
        writeEvent(json, "camera", hit.inCamera(sceneFromCamera));
        writeEvent(json, "scene", hit.inScene(sceneFromCamera));
        if (hit.movesByItself()) {
            json.writeObjectPropertyStart("own");
            write(json, hit.rest().event(), "properTime");
            write(json, "clockReading", hit.rest().clockReading());
            write(json, "frequencyRatio", hit.rest().dopplerFactor());
            json.writeEndObject();
        }
        json.writeEndObject();
    }

    private static void writeEvent(JsonGenerator json, String name, Event event) {
        json.writeObjectPropertyStart(name);
        write(json, event, "time");
        json.writeEndObject();
    }

    private static void write(JsonGenerator json, Event event, String time) {
        write(json, "position", event.x(), event.y(), event.z());
        write(json, time, event.time());
    }

    private static void write(JsonGenerator json, String name, double value) {
        json.writeName(name);
        JsonText.write(json, value);
    }

    private static void write(JsonGenerator json, String name, double... values) {
        json.writeArrayPropertyStart(name);
        for (double value : values) {
            JsonText.write(json, value);
        }
        json.writeEndArray();
    }
}
