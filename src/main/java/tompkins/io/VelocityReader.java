package tompkins.io;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.io.JsonValue.JsonList;
import tompkins.io.JsonValue.JsonNumber;
import tompkins.io.JsonValue.JsonObject;
import tompkins.io.JsonValue.Member;
import tompkins.property.InvalidPropertyException;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;

/** Makes velocities from JSON: three components, or a number on one scale with a direction. */
final class VelocityReader {

    static final String DIRECTION = "direction";

    private final Problems problems;
    private final ValueReader values;

    VelocityReader(Problems problems, ValueReader values) {
        this.problems = problems;
        this.values = values;
    }

    /** The velocity, or null if a mistake was noted. */
    Velocity read(JsonValue value, String path) {
        try {
            if (value instanceof JsonList) {
                Vector3dc components = values.vector(value, path);
                return components == null ? null : Velocity.of(components);
            }
            if (value instanceof JsonObject object) {
                return scaled(object, path, null);
            }
            values.refuse(
                    value, path, "three numbers [x, y, z] in units of c, or an object with one of " + scaleKeys());
        } catch (InvalidPropertyException invalid) {
            note(invalid, value, path);
        }
        return null;
    }

    /** A velocity with another speed, another direction or both; null if a mistake was noted. */
    Velocity changed(JsonObject parts, String path, Velocity present) {
        try {
            return scaled(parts, path, present);
        } catch (InvalidPropertyException invalid) {
            note(invalid, parts, path);
            return null;
        }
    }

    private void note(InvalidPropertyException invalid, JsonValue value, String path) {
        problems.note(invalid, value, path, SpeedScale.roundingHint(numbers(value)));
    }

    /** The numbers of a velocity, as they are written. */
    private static Stream<String> numbers(JsonValue value) {
        if (value instanceof JsonList list) {
            return list.values().stream().flatMap(VelocityReader::numbers);
        }
        if (value instanceof JsonObject object) {
            Member beta = object.members().get(SpeedScale.BETA.key());
            return beta == null ? Stream.empty() : numbers(beta.value());
        }
        return value instanceof JsonNumber number ? Stream.of(number.text()) : Stream.empty();
    }

    /** A velocity of which the present one, if there is one, has what is not given. */
    private Velocity scaled(JsonObject object, String path, Velocity present) {
        List<SpeedScale> given = Arrays.stream(SpeedScale.values())
                .filter(scale -> object.members().containsKey(scale.key()))
                .toList();
        List<String> known = new ArrayList<>(
                Arrays.stream(SpeedScale.values()).map(SpeedScale::key).toList());
        known.add(DIRECTION);
        boolean clear = problems.noteUnknownKeys(object, path, known);
        Vector3dc direction = present == null ? new Vector3d(0, 0, 1) : present.givenDirection();
        if (object.members().containsKey(DIRECTION)) {
            direction = values.vector(member(object, DIRECTION), path + "." + DIRECTION);
        }
        if (present != null && given.isEmpty()) {
            return direction == null || !clear ? null : present.along(direction, SpeedScale.BETA);
        }
        if (given.size() != 1) {
            if (clear) {
                String what = given.isEmpty() ? "none" : given.size() + " of them";
                problems.add(object, path, "must have exactly one of " + scaleKeys() + ", has " + what);
            }
            return null;
        }
        Double number = values.unlimited(
                member(object, given.get(0).key()), path + "." + given.get(0).key());
        return number == null || direction == null ? null : Velocity.of(given.get(0), number, direction);
    }

    private static JsonValue member(JsonObject object, String key) {
        Member member = object.members().get(key);
        return member.value();
    }

    private static String scaleKeys() {
        return Arrays.stream(SpeedScale.values()).map(SpeedScale::key).collect(Collectors.joining(", "));
    }
}
