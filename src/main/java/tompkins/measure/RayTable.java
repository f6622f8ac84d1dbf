package tompkins.measure;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import org.joml.Vector3dc;
import tompkins.spacetime.Event;

/** What a table of rays says about each ray: a row is a sighting, and a column a number or a name. */
public final class RayTable {

    private static final String LENGTH = "scene units";
    private static final String ANGLE = "degrees";

    /**
     * A column.
     *
     * @param name words with underscores between them
     * @param unit unit of its numbers; empty if they have none
     * @param value a number, a text, or null where the ray has no such thing
     */
    public record Column(String name, String unit, Function<Sighting, Object> value) {

        /** The name, with the unit in brackets. */
        public String heading() {
            return unit.isEmpty() ? name : name + " [" + unit + "]";
        }
    }

    /** All columns, in their order. */
    public static final List<Column> COLUMNS = columns();

    private RayTable() {}

    /** The column of a name, which is one of them. */
    public static Column column(String name) {
        return COLUMNS.stream()
                .filter(column -> column.name().equals(name))
                .findFirst()
                .orElseThrow();
    }

    private static List<Column> columns() {
        List<Column> columns = new ArrayList<>();
        columns.add(new Column("pixel_x", "pixels", sighting -> sighting.x() - 0.5));
        columns.add(new Column("pixel_y", "pixels", sighting -> sighting.y() - 0.5));
        addVector(columns, "camera_direction", "", Sighting::cameraDirection);
        columns.add(new Column("camera_angle_to_velocity", ANGLE, sighting -> Math.toDegrees(sighting.cameraAngle())));
        columns.add(new Column(
                "lens_time",
                LENGTH,
                ofRay(sighting -> sighting.life().cameraStart().time())));
        addEvent(columns, "scene_start", ofRay(sighting -> sighting.life().sceneStart()));
        addVector(columns, "scene_direction", "", Sighting::sceneDirection);
        columns.add(new Column("scene_angle_to_velocity", ANGLE, sighting -> Math.toDegrees(sighting.sceneAngle())));
        columns.add(new Column("doppler_factor", "", Sighting::dopplerFactor));
        columns.add(new Column(
                "object", "", ofHit(sighting -> sighting.hit().object().description())));
        columns.add(new Column(
                "object_frame",
                "",
                ofHit(sighting -> sighting.hit().frame().name().toLowerCase(Locale.ROOT))));
        addEvent(columns, "hit_scene", Sighting::inScene);
        addEvent(columns, "hit_camera", Sighting::inCamera);
        addEvent(columns, "hit_own", ofHit(sighting -> sighting.hit().rest().event()));
        addVector(columns, "normal", "", ofHit(sighting -> sighting.hit().rest().normal()));
        columns.add(new Column(
                "surface_u", "", ofHit(sighting -> sighting.hit().rest().u())));
        columns.add(new Column(
                "surface_v", "", ofHit(sighting -> sighting.hit().rest().v())));
        columns.add(new Column(
                "proper_time", LENGTH, ofHit(sighting -> sighting.hit().rest().clockReading())));
        columns.add(
                new Column("distance", LENGTH, ofHit(sighting -> sighting.hit().distance())));
        columns.add(new Column("camera_distance", LENGTH, Sighting::cameraDistance));
        columns.add(
                new Column("red", "", ofRay(sighting -> sighting.life().colour().red())));
        columns.add(new Column(
                "green", "", ofRay(sighting -> sighting.life().colour().green())));
        columns.add(new Column(
                "blue", "", ofRay(sighting -> sighting.life().colour().blue())));
        return List.copyOf(columns);
    }

    private static <T> Function<Sighting, T> ofRay(Function<Sighting, T> value) {
        return sighting -> sighting.life() == null ? null : value.apply(sighting);
    }

    private static <T> Function<Sighting, T> ofHit(Function<Sighting, T> value) {
        return sighting -> sighting.hit() == null ? null : value.apply(sighting);
    }

    private static <T> Function<Sighting, Object> part(Function<Sighting, T> whole, Function<T, Object> part) {
        return sighting -> {
            T value = whole.apply(sighting);
            return value == null ? null : part.apply(value);
        };
    }

    private static void addVector(
            List<Column> columns, String name, String unit, Function<Sighting, ? extends Vector3dc> vector) {
        columns.add(new Column(name + "_x", unit, part(vector, Vector3dc::x)));
        columns.add(new Column(name + "_y", unit, part(vector, Vector3dc::y)));
        columns.add(new Column(name + "_z", unit, part(vector, Vector3dc::z)));
    }

    private static void addEvent(List<Column> columns, String name, Function<Sighting, Event> event) {
        addVector(columns, name, LENGTH, sighting -> {
            Event value = event.apply(sighting);
            return value == null ? null : value.position();
        });
        columns.add(new Column(name + "_time", LENGTH, part(event, Event::time)));
    }
}
