package tompkins.io;

import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;
import org.joml.Vector2ic;
import org.joml.Vector3dc;
import org.joml.Vector3ic;
import tompkins.camera.ThinLensCamera;
import tompkins.io.JsonValue.JsonChange;
import tompkins.io.JsonValue.JsonList;
import tompkins.io.JsonValue.JsonNumber;
import tompkins.io.JsonValue.JsonObject;
import tompkins.io.JsonValue.JsonText;
import tompkins.io.JsonValue.Member;
import tompkins.property.AddedTypes;
import tompkins.property.Descriptions;
import tompkins.property.InvalidPropertyException;
import tompkins.ray.Colour;
import tompkins.ray.MeshData;
import tompkins.ray.PixelPicture;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.studio.StudioPath;

/** Makes descriptions from JSON, key by key, as the components of records say; keys that are missing get defaults. */
final class DescriptionReader {

    /** The key that names the member of a family. */
    static final String TYPE = "type";

    private final Problems problems;
    private final ValueReader values;
    private final VelocityReader velocities;

    /** What reads the values that are neither descriptions nor words of a list. */
    private final Map<Class<?>, BiFunction<JsonValue, String, Object>> plainReaders;

    DescriptionReader(Problems problems, SceneFolder folder) {
        this.problems = problems;
        values = new ValueReader(problems);
        velocities = new VelocityReader(problems, values);
        FileContentReader files = new FileContentReader(problems, folder);
        plainReaders = Map.ofEntries(
                Map.entry(double.class, values::unlimited),
                Map.entry(int.class, values::unlimitedWhole),
                Map.entry(long.class, values::longNumber),
                Map.entry(boolean.class, values::flag),
                Map.entry(String.class, values::text),
                Map.entry(Vector3dc.class, values::vector),
                Map.entry(Vector3ic.class, values::wholeVector),
                Map.entry(Vector2ic.class, values::wholePair),
                Map.entry(Colour.class, values::colour),
                Map.entry(Velocity.class, velocities::read),
                Map.entry(PixelPicture.class, (value, path) -> files.read(value, path, FileKind.PICTURE)),
                Map.entry(MeshData.class, (value, path) -> files.read(value, path, FileKind.MESH)));
    }

    /**
     * A value of any type that a component can have.
     *
     * @param present what is there, if the value is only a change of it
     * @return null if a mistake was noted
     */
    private Object read(Type type, JsonValue value, String path, Object present) {
        if (value instanceof JsonChange change) {
            return changed(type, change.parts(), path, present);
        }
        Optional<Class<?>> element = Descriptions.elementType(type);
        return element.isPresent() ? list(element.get(), value, path) : read((Class<?>) type, value, path);
    }

    private Object read(Class<?> type, JsonValue value, String path) {
        BiFunction<JsonValue, String, Object> plain = plainReaders.get(type);
        if (plain != null) {
            return plain.apply(value, path);
        }
        if (DescriptionTypes.isFamily(type)) {
            return member(type, value, path);
        }
        if (type.isEnum()) {
            return values.constant(type, value, path);
        }
        if (type.isRecord()) {
            return value instanceof JsonObject object
                    ? record(type, object, path, List.of(), Descriptions.standard(type))
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
            elements.add(read(element, list.values().get(i), path + "[" + i + "]", null));
        }
        return elements.contains(null) ? null : elements;
    }

    private Object member(Class<?> family, JsonValue value, String path) {
        if (!(value instanceof JsonObject object)) {
            List<String> names = DescriptionTypes.memberNames(family);
            String name = value instanceof JsonText text && names.contains(text.text()) ? text.text() : names.get(0);
            return values.refuse(value, path, "an object in braces, such as {\"type\": \"" + name + "\"}");
        }
        Class<?> member = member(family, object, path, DescriptionTypes.usualMember(family));
        return member == null ? null : record(member, object, path, List.of(TYPE), Descriptions.standard(member));
    }

    /**
     * The member of a family that an object names, or the usual one.
     *
     * @return null if a mistake was noted
     */
    private Class<?> member(Class<?> family, JsonObject object, String path, Optional<Class<?>> usual) {
        List<String> names = DescriptionTypes.memberNames(family);
        Member type = object.members().get(TYPE);
        if (type == null) {
            if (usual.isEmpty()) {
                problems.add(object, path, "needs a key \"type\"; allowed are " + String.join(", ", names));
            }
            return usual.orElse(null);
        }
        String name = type.value() instanceof JsonText text ? text.text() : null;
        int index = names.indexOf(name);
        if (index >= 0) {
            return Descriptions.members(family).get(index);
        }
        String hint = name == null
                ? ""
                : DescriptionTypes.homeOfType(name)
                        .map(key -> "; " + name + " belongs under \"" + key + "\"")
                        .orElseGet(() -> Spelling.hint(name, names));
        problems.add(
                type.value(),
                path,
                "unknown type " + type.value().shown() + "; allowed are " + String.join(", ", names)
                        + AddedTypes.withJars() + hint);
        return null;
    }

    /**
     * What is there, with other values for some of its parts. Another type has its default values for the others.
     *
     * @return null if a mistake was noted
     */
    private Object changed(Type type, JsonObject parts, String path, Object present) {
        if (present instanceof List<?> list) {
            return changedList(Descriptions.elementType(type).orElseThrow(), parts, path, list);
        }
        if (present instanceof Vector3dc vector) {
            return values.changedVector(parts, path, vector);
        }
        if (present instanceof Velocity velocity) {
            return velocities.changed(parts, path, velocity);
        }
        if (!(present instanceof Record)) {
            problems.noteUnknownKeys(parts, path, List.of());
            return null;
        }
        if (!DescriptionTypes.isFamily((Class<?>) type)) {
            return record(present.getClass(), parts, path, List.of(), present);
        }
        Class<?> member = member((Class<?>) type, parts, path, Optional.of(present.getClass()));
        if (member == null) {
            return null;
        }
        Object base = member == present.getClass() ? present : Descriptions.standard(member);
        return record(member, parts, path, List.of(TYPE), base);
    }

    private List<Object> changedList(Class<?> element, JsonObject parts, String path, List<?> present) {
        List<Object> changed = new ArrayList<>(present);
        for (Map.Entry<String, Member> part : parts.members().entrySet()) {
            String place = part.getKey();
            JsonValue value = part.getValue().value();
            int index =
                    place.startsWith("[") ? Integer.parseInt(place.substring(1, place.length() - 1)) : present.size();
            if (index < present.size()) {
                changed.set(index, read(element, value, path + place, present.get(index)));
            } else {
                String allowed = String.join("", StudioPath.stepsFrom(present));
                problems.add(
                        value,
                        path,
                        "has no part " + place + (allowed.isEmpty() ? "; it is empty" : ", only " + allowed));
                return null;
            }
        }
        return changed.contains(null) ? null : changed;
    }

    /**
     * A record.
     *
     * @param otherKeys keys that are allowed besides the names of the components
     * @param standard a record of this type, whose values stand for keys that are missing
     * @return null if a mistake was noted
     */
    Object record(Class<?> type, JsonObject object, String path, List<String> otherKeys, Object standard) {
        Member focus = object.members().get("focus");
        if (standard instanceof ThinLensCamera camera && focus != null && focus.value() instanceof JsonNumber) {
            return focused(object, focus, path, otherKeys, camera);
        }
        List<String> keys = new ArrayList<>(otherKeys);
        keys.addAll(DescriptionTypes.keys(type));
        boolean clear = problems.noteUnknownKeys(object, path, keys, key -> home(key, path, standard));
        List<RecordComponent> components = Descriptions.components(type);
        List<Object> present = Descriptions.values(standard);
        Object[] arguments = new Object[components.size()];
        Set<String> replaced = new HashSet<>();
        for (int i = 0; i < components.size(); i++) {
            RecordComponent component = components.get(i);
            String key = component.getName();
            Member member = object.members().get(key);
            if (member != null) {
                arguments[i] = read(component.getGenericType(), member.value(), inner(path, key), present.get(i));
            }
            if (arguments[i] == null) {
                arguments[i] = present.get(i);
                if (member != null) {
                    replaced.add(key);
                }
            }
        }
        Object made = make(type, arguments, standard, object, path, replaced);
        for (RecordComponent component : components) {
            Member member = object.members().get(component.getName());
            if (made != null && member != null && !replaced.contains(component.getName())) {
                made = values.limited(component.getType(), made, member.value(), inner(path, component.getName()));
            }
        }
        return clear && replaced.isEmpty() ? made : null;
    }

    /** A camera whose focus is a number: its distance, in the place of what was in focus. */
    private Object focused(JsonObject object, Member focus, String path, List<String> otherKeys, Record camera) {
        Map<String, Member> members = new LinkedHashMap<>(object.members());
        members.remove("focus");
        if (members.put("focusDistance", focus) != null) {
            problems.add(focus.value(), inner(path, "focus"), "is given twice; leave focus or focusDistance out");
            return null;
        }
        Object unfocused = Descriptions.with(
                Descriptions.with(camera, "focusDistance", 0.0), "focus", ThinLensCamera.DEFAULT.focus());
        return record(
                ThinLensCamera.class,
                new JsonObject(object.line(), object.column(), members),
                path,
                otherKeys,
                unfocused);
    }

    /** A hint at where a key belongs: to a part of a description, to the scene itself, or to what holds objects. */
    private static String home(String key, String path, Object whole) {
        // each element of a list may be meant, and its parts are those of many
        Object scene = path.contains("[") ? whole : Studio.DEFAULT;
        if (scene == Studio.DEFAULT && DescriptionTypes.keys(Studio.class).contains(key)) {
            return Spelling.meant(key + "\" beside \"camera");
        }
        return part(key, whole)
                .or(() -> part(key, scene))
                .map(Spelling::meant)
                .or(() -> DescriptionTypes.ownerOfKey(key, whole.getClass())
                        .map(owner -> "; " + owner + " has \"" + key + "\""))
                .orElse("");
    }

    /** The way to the part of something that has a key. */
    static Optional<String> part(String key, Object whole) {
        return StudioPath.stepsFrom(whole).stream()
                .filter(part -> StudioPath.stepsFrom(StudioPath.ROOT.then(part).get(whole))
                        .contains(key))
                .findFirst()
                .map(part -> part + "." + key);
    }

    /** The way to a part of something. */
    static String inner(String path, String key) {
        return path.isEmpty() ? key : path + "." + key;
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
                String key = Problems.component(invalid);
                int index = DescriptionTypes.keys(type).indexOf(key);
                RecordComponent component =
                        index < 0 ? null : Descriptions.components(type).get(index);
                if (replaced.isEmpty() || invalid.isByItself()) {
                    problems.note(invalid, object, path);
                }
                if (!replaced.add(key) || component == null) {
                    return null;
                }
                arguments[index] = Descriptions.value(component, standard);
            }
        }
    }
}
