package tompkins.io;

import java.lang.reflect.RecordComponent;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.joml.Vector2ic;
import org.joml.Vector3dc;
import org.joml.Vector3ic;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.ray.MeshData;
import tompkins.ray.PixelPicture;
import tompkins.spacetime.Velocity;

/** What the reference of scene files calls the kinds of values, and where it describes them. */
final class ValueKind {

    private static final Map<Class<?>, String> PLAIN = Map.of(
            double.class, "number",
            int.class, "whole number",
            long.class, "whole number",
            boolean.class, "yes or no",
            String.class, "text",
            Vector3dc.class, "vector",
            Vector3ic.class, "vector of whole numbers",
            Vector2ic.class, "two whole numbers `[x, y]`",
            Colour.class, "colour");

    private ValueKind() {}

    /** The kind of a component's value, as Markdown. */
    static String of(RecordComponent component) {
        Optional<Class<?>> element = Descriptions.elementType(component.getGenericType());
        if (element.isPresent()) {
            return "list of [" + words(element.get().getSimpleName()) + "s](#" + section(element.get()) + ")";
        }
        Class<?> type = component.getType();
        if (type.isEnum()) {
            return "`\"" + String.join("\"`, `\"", DescriptionTypes.constantNames(type)) + "\"`";
        }
        if (type == PixelPicture.class) {
            return "[picture](#pictures)";
        }
        if (type == MeshData.class) {
            return "[mesh](#meshes)";
        }
        if (type == Velocity.class) {
            return "[velocity](#velocities)";
        }
        return PLAIN.containsKey(type)
                ? PLAIN.get(type)
                : "[" + words(type.getSimpleName()) + "](#" + section(type) + ")";
    }

    /** Whether a type has a section of its own: families, and records that are not written as plain values. */
    static boolean hasSection(Class<?> type) {
        return DescriptionTypes.isFamily(type) || type.isRecord() && !PLAIN.containsKey(type);
    }

    /** The heading of a family. */
    static String title(Class<?> family) {
        String name = capitalised(words(family.getSimpleName()));
        return name + (name.endsWith("sh") ? "es" : "s");
    }

    private static String section(Class<?> type) {
        return anchor(DescriptionTypes.isFamily(type) ? title(type) : words(type.getSimpleName()));
    }

    /** The link to a heading, as hosts of Markdown make it. */
    static String anchor(String heading) {
        return heading.toLowerCase(Locale.ROOT).replace(' ', '-');
    }

    /** The words of a type's name, in lower case. */
    static String words(String name) {
        return name.replaceAll("(?<=[a-z])(?=[A-Z])", " ").toLowerCase(Locale.ROOT);
    }

    /** A text that begins with a capital letter. */
    static String capitalised(String text) {
        return text.substring(0, 1).toUpperCase(Locale.ROOT) + text.substring(1);
    }
}
