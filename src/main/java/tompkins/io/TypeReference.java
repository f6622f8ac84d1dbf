package tompkins.io;

import java.lang.reflect.RecordComponent;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.joml.Vector2ic;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.joml.Vector3ic;
import tompkins.property.Descriptions;
import tompkins.property.InvalidPropertyException;
import tompkins.property.Meaning;
import tompkins.ray.Colour;
import tompkins.ray.FileContent;
import tompkins.ray.MeshData;
import tompkins.ray.PixelPicture;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;

/**
 * What a type of scene files means, key by key; of a family such as the surfaces, its types.
 *
 * @param name what scene files call it
 * @param family name of the family that it belongs to; empty if there is none
 * @param meaning one sentence without a full stop
 * @param members the types of a family with their meanings; empty if it is none
 * @param example the usual values as a scene file writes them; empty for a family
 */
public record TypeReference(
        String name, String family, String meaning, List<Key> keys, Map<String, String> members, String example) {

    /**
     * A key of a type.
     *
     * @param value the kind of its value
     * @param unit empty if it has none
     * @param allowed which values of this kind are allowed, whatever the other keys are; empty if all are
     * @param standard the value that it has if it is missing; empty if that has no short name
     */
    public record Key(String name, String value, String meaning, String unit, String allowed, String standard) {}

    private static final Map<Class<?>, String> KINDS = Map.ofEntries(
            Map.entry(double.class, "number"),
            Map.entry(int.class, "whole number"),
            Map.entry(long.class, "whole number"),
            Map.entry(boolean.class, "true or false"),
            Map.entry(String.class, "text"),
            Map.entry(Vector3dc.class, "[x, y, z]"),
            Map.entry(Vector3ic.class, "[x, y, z] of whole numbers"),
            Map.entry(Vector2ic.class, "[x, y] of whole numbers"),
            Map.entry(Colour.class, "[red, green, blue], or a number for a grey"),
            Map.entry(Velocity.class, "[x, y, z], or a speed with a direction"),
            Map.entry(PixelPicture.class, "name of a picture file"),
            Map.entry(MeshData.class, "name of an OBJ file"));

    private static final DescriptionWriter WRITER = new DescriptionWriter(file -> false);

    /** Values that are refused where not all are allowed: the refusal tells which are. */
    private static final Map<Class<?>, List<Object>> REFUSED = Map.of(
            double.class,
            List.of(Double.NaN),
            int.class,
            List.of(Integer.MIN_VALUE, Integer.MAX_VALUE),
            Vector3dc.class,
            List.of(new Vector3d(), new Vector3d(1e300)));

    /** The studio, and all families and single types that it can hold, level by level. */
    static Set<Class<?>> types() {
        Set<Class<?>> found = new LinkedHashSet<>();
        Deque<Class<?>> open = new ArrayDeque<>(List.of(Studio.class));
        while (!open.isEmpty()) {
            Class<?> type = open.remove();
            if (Descriptions.isDescription(type) && !KINDS.containsKey(type) && found.add(type)) {
                open.addAll(Descriptions.members(type));
                if (type.isRecord()) {
                    Descriptions.components(type).forEach(component -> open.add(typeOf(component)));
                }
            }
        }
        return found;
    }

    /** The type of a component, or that of the elements of its list. */
    static Class<?> typeOf(RecordComponent component) {
        return Descriptions.elementType(component.getGenericType()).orElse(component.getType());
    }

    /** The names of all types and families. */
    public static List<String> names() {
        return types().stream().map(Descriptions::name).distinct().toList();
    }

    /** The types that have a name, in small or capital letters: one of objects and one of lamps may have the same. */
    public static List<TypeReference> of(String name) {
        return types().stream()
                .filter(type -> Descriptions.name(type).equalsIgnoreCase(name))
                .map(type -> type.isRecord() ? ofRecord(type) : ofFamily(type))
                .toList();
    }

    private static TypeReference ofFamily(Class<?> family) {
        String meaning = DescriptionTypes.usualMember(family)
                .map(usual -> "One of these types; without a \"type\", " + Descriptions.name(usual))
                .orElse("One of these types");
        Map<String, String> types = new LinkedHashMap<>();
        Descriptions.members(family).forEach(member -> types.put(Descriptions.name(member), meaningOf(member)));
        return new TypeReference(Descriptions.name(family), "", meaning, List.of(), types, "");
    }

    private static TypeReference ofRecord(Class<?> type) {
        String family = familyOf(type).map(Descriptions::name).orElse("");
        return new TypeReference(
                Descriptions.name(type),
                family,
                meaningOf(type),
                keysOf(type),
                Map.of(),
                JsonLayout.text(example(type, family.isEmpty())));
    }

    private static String meaningOf(Class<?> type) {
        return type.getAnnotation(Meaning.class).value();
    }

    /** The family that a type belongs to, which its key {@code type} tells from the others. */
    static Optional<Class<?>> familyOf(Class<?> type) {
        return types().stream()
                .filter(DescriptionTypes::isFamily)
                .filter(family -> Descriptions.members(family).contains(type))
                .findFirst();
    }

    /**
     * A type with its usual values, and with files of the bundled scenes; names and parts of a usual type are left out.
     */
    private static Map<String, Object> example(Class<?> type, boolean isAlone) {
        Map<String, Object> members = new LinkedHashMap<>();
        if (!isAlone) {
            members.put(DescriptionReader.TYPE, Descriptions.name(type));
        }
        Object standard = Descriptions.standard(type);
        for (RecordComponent component : Descriptions.components(type)) {
            Object value = Descriptions.value(component, standard);
            Class<?> kind = typeOf(component);
            boolean isUsual = DescriptionTypes.isFamily(kind)
                    && DescriptionTypes.usualMember(kind).isPresent();
            if (value instanceof FileContent) {
                members.put(
                        component.getName(), value instanceof MeshData ? "meshes/trefoil.obj" : "pictures/clock.png");
            } else if (!isUsual && !(value instanceof String) && !value.equals(List.of())) {
                members.put(component.getName(), WRITER.tree(component.getGenericType(), value));
            }
        }
        return members;
    }

    /** The keys of a type. */
    static List<Key> keysOf(Class<?> type) {
        return Descriptions.components(type).stream()
                .map(component -> key(type, component))
                .toList();
    }

    private static Key key(Class<?> type, RecordComponent component) {
        Meaning meaning = component.getAnnotation(Meaning.class);
        Object standard = Descriptions.value(component, Descriptions.standard(type));
        boolean isFile = standard instanceof FileContent;
        Object tree = isFile ? "" : WRITER.tree(component.getGenericType(), standard);
        return new Key(
                component.getName(),
                kind(component),
                meaning.value(),
                meaning.unit(),
                allowed(type, component),
                isFile ? "" : JsonLayout.line(tree));
    }

    private static String kind(RecordComponent component) {
        Class<?> type = typeOf(component);
        String kind = type.isEnum()
                ? "one of \"" + String.join("\", \"", DescriptionTypes.constantNames(type)) + "\""
                : KINDS.getOrDefault(type, Descriptions.name(type));
        return component.getType() == type ? kind : "list of " + kind;
    }

    /** Which values are allowed, whatever the other keys say; empty if that is not known. */
    static String allowed(Class<?> type, RecordComponent component) {
        for (Object refused : REFUSED.getOrDefault(component.getType(), List.of())) {
            try {
                Descriptions.with(Descriptions.standard(type), component.getName(), refused);
            } catch (InvalidPropertyException refusal) {
                if (refusal.isByItself()) {
                    return refusal.problem().replaceFirst("^must be (.*), was .*", "$1");
                }
            }
        }
        return "";
    }
}
