package tompkins.measure;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import org.joml.Vector3dc;
import tompkins.ray.Colour;
import tompkins.spacetime.Event;
import tompkins.studio.Studio;
import tompkins.trace.SampleHistory;

/** What a table of rays tells of each ray: what it ends at, not what it met before. */
public final class RayTable {

    private static final String LENGTH = "scene units";
    private static final String ANGLE = "degrees";

    /** What people are told, and what they call it. */
    private static final Map<String, String> NAMES = Map.of(
            "pixel_x", "column",
            "pixel_y", "row",
            "object", "object",
            "doppler_factor", "Doppler factor",
            "hit_scene_time", "time (scene)",
            "red", "red",
            "green", "green",
            "blue", "blue");

    private final List<Fact> row = new ArrayList<>();

    private RayTable() {}

    /** A row without values, whose keys and units are the headings of the table. */
    public static List<Fact> headings() {
        return row(new Sighting(Studio.DEFAULT, Double.NaN, Double.NaN, null));
    }

    /** The row of a sighting; without values where there are none. */
    public static List<Fact> row(Sighting sighting) {
        RayTable table = new RayTable();
        table.add(sighting);
        return table.row;
    }

    /** The number of a sighting in the column of a key; NaN if it has none. */
    public static double number(Sighting sighting, String key) {
        return row(sighting).stream()
                .filter(fact -> fact.key().equals(key))
                .mapToDouble(fact -> ((Quantity) fact).value())
                .findFirst()
                .orElseThrow();
    }

    private void add(Sighting sighting) {
        SampleHistory life = sighting.life();
        SampleHistory.Encounter hit = sighting.hit();
        SampleHistory.Rest rest = hit == null ? null : hit.rest();
        Colour colour = life == null ? null : life.colour();
        add("pixel_x", "pixels", sighting.x() - 0.5);
        add("pixel_y", "pixels", sighting.y() - 0.5);
        addVector("camera_direction", "", sighting.cameraDirection());
        add("camera_angle_to_velocity", ANGLE, Math.toDegrees(sighting.cameraAngle()));
        add("lens_time", LENGTH, life, ray -> ray.cameraStart().time());
        addEvent("scene_start", life == null ? null : life.sceneStart());
        addVector("scene_direction", "", sighting.sceneDirection());
        add("scene_angle_to_velocity", ANGLE, Math.toDegrees(sighting.sceneAngle()));
        add("doppler_factor", "", sighting.dopplerFactor());
        add("object", hit == null ? null : hit.object().description());
        add("object_frame", hit == null ? null : hit.frame().name().toLowerCase(Locale.ROOT));
        addEvent("hit_scene", sighting.inScene());
        addEvent("hit_camera", sighting.inCamera());
        addEvent("hit_own", rest == null ? null : rest.event());
        addVector("normal", "", rest == null ? null : rest.normal());
        add("surface_u", "", rest, SampleHistory.Rest::u);
        add("surface_v", "", rest, SampleHistory.Rest::v);
        add("proper_time", LENGTH, rest, seen -> seen.event().time());
        add("distance", LENGTH, hit, SampleHistory.Encounter::distance);
        add("camera_distance", LENGTH, sighting.cameraDistance());
        add("red", "", colour, Colour::red);
        add("green", "", colour, Colour::green);
        add("blue", "", colour, Colour::blue);
        add("clock_reading", LENGTH, rest, SampleHistory.Rest::clockReading);
    }

    private void add(String key, String text) {
        row.add(new Fact.Word(key, NAMES.getOrDefault(key, ""), text));
    }

    private void add(String key, String unit, double value) {
        row.add(Quantity.exact(key, NAMES.getOrDefault(key, ""), unit, value));
    }

    /** A number of something that may be missing. */
    private <T> void add(String key, String unit, T whole, ToDoubleFunction<T> number) {
        add(key, unit, whole == null ? Double.NaN : number.applyAsDouble(whole));
    }

    private void addVector(String key, String unit, Vector3dc vector) {
        add(key + "_x", unit, vector, Vector3dc::x);
        add(key + "_y", unit, vector, Vector3dc::y);
        add(key + "_z", unit, vector, Vector3dc::z);
    }

    private void addEvent(String key, Event event) {
        addVector(key, LENGTH, event == null ? null : event.position());
        add(key + "_time", LENGTH, event, Event::time);
    }
}
