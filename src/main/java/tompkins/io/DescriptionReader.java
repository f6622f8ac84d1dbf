package tompkins.io;

import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.joml.Vector2ic;
import org.joml.Vector3dc;
import org.joml.Vector3ic;
import tompkins.io.JsonValue.JsonList;
import tompkins.io.JsonValue.JsonObject;
import tompkins.io.JsonValue.JsonText;
import tompkins.io.JsonValue.Member;
import tompkins.property.Descriptions;
import tompkins.property.InvalidPropertyException;
import tompkins.ray.Colour;
import tompkins.ray.MeshData;
import tompkins.ray.PixelPicture;
import tompkins.spacetime.Velocity;

/**
 * Makes descriptions from JSON, key by key, as the components of the records say; missing keys get their default
 * values.
 */
final class DescriptionReader {

    /** The key that names the member of a family. */
    static final String TYPE = "type";

    private final Problems problems;
    private final ValueReader values;
    private final VelocityReader velocities;
    private final FileContentReader files;

    DescriptionReader(Problems problems, SceneFolder folder) {
        this.problems = problems;
        values = new ValueReader(problems);
        velocities = new VelocityReader(problems, values);
        files = new FileContentReader(problems, folder);
    }

    /**
     * A value of any type that a component can have.
     *
     * @return null if a mistake was noted
     */
    private Object read(Type type, JsonValue value, String path) {
        Optional<Class<?>> element = Descriptions.elementType(type);
        return element.isPresent() ? list(element.get(), value, path) : read((Class<?>) type, value, path);
    }

    private Object read(Class<?> type, JsonValue value, String path) {
        if (DescriptionTypes.isFamily(type)) {
            return member(type, value, path);
        }
        if (type.isEnum()) {
            return values.constant(type, value, path);
        }
        if (type == double.class) {
            return values.number(value, path);
        }
        if (type == int.class) {
            return values.wholeNumber(value, path);
        }
        if (type == long.class) {
            return values.longNumber(value, path);
        }
        if (type == boolean.class) {
            return values.flag(value, path);
        }
        if (type == String.class) {
            return values.text(value, path);
        }
        if (type == Vector3dc.class) {
            return values.vector(value, path);
        }
        if (type == Vector3ic.class) {
            return values.wholeVector(value, path);
        }
        if (type == Vector2ic.class) {
            return values.wholePair(value, path);
        }
        if (type == Colour.class) {
            return values.colour(value, path);
        }
        if (type == Velocity.class) {
            return velocities.read(value, path);
        }
        if (type == PixelPicture.class) {
            return files.read(value, path, FileContentParser.PICTURE);
        }
        if (type == MeshData.class) {
            return files.read(value, path, FileContentParser.MESH);
        }
        if (type.isRecord()) {
            return value instanceof JsonObject object
                    ? record(type, object, path, List.of())
                    : values.refuse(value, path, "an object in braces");
        }
        throw new IllegalStateException("no way to read a " + type + " from a scene file");
    }

    private List<Object> list(Class<?> element, JsonValue value, String path) {
        if (!(value instanceof JsonList list)) {
            return values.refuse(value, path, "a list in brackets [ ]");
        }
        List<Object> elements = new ArrayList<>();
        for (int i = 0; i < list.values().size(); i++) {
            elements.add(read(element, list.values().get(i), path + "[" + i + "]"));
        }
        return elements.contains(null) ? null : elements;
    }

    private Object member(Class<?> family, JsonValue value, String path) {
        List<String> names = DescriptionTypes.memberNames(family);
        if (!(value instanceof JsonObject object)) {
            return values.refuse(value, path, "an object in braces, such as {\"type\": \"" + names.get(0) + "\"}");
        }
        Member type = object.members().get(TYPE);
        if (type == null) {
            Optional<Class<?>> usual = DescriptionTypes.usualMember(family);
            if (usual.isPresent()) {
                return record(usual.get(), object, path, List.of(TYPE));
            }
            problems.add(object, path, "needs a key \"type\"; allowed are " + String.join(", ", names));
            return null;
        }
        String name = type.value() instanceof JsonText text ? text.text() : null;
        int index = names.indexOf(name);
        if (index >= 0) {
            return record(Descriptions.members(family).get(index), object, path, List.of(TYPE));
        }
        String hint = name == null ? "" : Spelling.hint(name, names);
        problems.add(
                type.value(),
                path,
                "unknown type " + type.value().shown() + "; allowed are " + String.join(", ", names) + hint);
        return null;
    }

    /**
     * A record.
     *
     * @param otherKeys keys that are allowed besides the names of the components
     * @return null if a mistake was noted
     */
    Object record(Class<?> type, JsonObject object, String path, List<String> otherKeys) {
        List<String> keys = new ArrayList<>(otherKeys);
        keys.addAll(DescriptionTypes.keys(type));
        boolean clear = Refusal.noteUnknownKeys(problems, object, path, keys);
        List<RecordComponent> components = Descriptions.components(type);
        Object[] arguments = new Object[components.size()];
        Set<String> replaced = new HashSet<>();
        Object standard = Descriptions.standard(type);
        for (int i = 0; i < components.size(); i++) {
            RecordComponent component = components.get(i);
            String key = component.getName();
            Member member = object.members().get(key);
            if (member != null) {
                String inner = path.isEmpty() ? key : path + "." + key;
                arguments[i] = read(component.getGenericType(), member.value(), inner);
            }
            if (arguments[i] == null) {
                arguments[i] = Descriptions.value(component, standard);
                if (member != null) {
                    replaced.add(key);
                }
            }
        }
        Object made = make(type, arguments, standard, object, path, replaced);
        return clear && replaced.isEmpty() ? made : null;
    }

    /**
     * Makes the record. A value that its constructor refuses is noted and replaced by the default, to find what else is
     * wrong. After that only values that are wrong by themselves are noted: others may be wrong only beside the default
     * that has replaced a wrong value.
     */
    private Object make(
            Class<?> type, Object[] arguments, Object standard, JsonObject object, String path, Set<String> replaced) {
        while (true) {
            try {
                return Descriptions.make(type, arguments);
            } catch (InvalidPropertyException invalid) {
                String key = Refusal.component(invalid);
                int index = DescriptionTypes.keys(type).indexOf(key);
                RecordComponent component =
                        index < 0 ? null : Descriptions.components(type).get(index);
                if (replaced.isEmpty() || invalid.isByItself()) {
                    Refusal.note(problems, invalid, object, path);
                }
                if (!replaced.add(key) || component == null) {
                    return null;
                }
                arguments[index] = Descriptions.value(component, standard);
            }
        }
    }
}
