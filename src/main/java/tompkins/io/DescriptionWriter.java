package tompkins.io;

import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import org.joml.Vector2ic;
import org.joml.Vector3dc;
import org.joml.Vector3ic;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.ray.FileContent;
import tompkins.spacetime.Velocity;

/**
 * Makes maps and lists, ready for {@link JsonLayout}, from descriptions; leaves out values that are those of the
 * default.
 */
final class DescriptionWriter {

    private final Predicate<FileContent> embedded;

    /** A writer that includes the files of some pictures and meshes, and names the others. */
    DescriptionWriter(Predicate<FileContent> embedded) {
        this.embedded = embedded;
    }

    /** The value of a component of type {@code type}. */
    Object tree(Type type, Object value) {
        Optional<Class<?>> element = Descriptions.elementType(type);
        if (element.isPresent()) {
            return ((List<?>) value)
                    .stream().map(each -> tree(element.get(), each)).toList();
        }
        if (value instanceof Colour colour) {
            return tree(colour);
        }
        if (value instanceof Record record) {
            return record(record, DescriptionTypes.isFamily((Class<?>) type));
        }
        if (value instanceof Enum<?>) {
            return DescriptionTypes.constantName(value);
        }
        if (value instanceof Vector3dc vector) {
            return List.of(vector.x(), vector.y(), vector.z());
        }
        if (value instanceof Vector3ic vector) {
            return List.of(vector.x(), vector.y(), vector.z());
        }
        if (value instanceof Vector2ic vector) {
            return List.of(vector.x(), vector.y());
        }
        if (value instanceof Velocity velocity) {
            return tree(velocity);
        }
        return value instanceof FileContent content ? tree(content) : value;
    }

    /** The keys of a record whose values are not those of the default. */
    private Map<String, Object> record(Record record, boolean named) {
        Map<String, Object> members = new LinkedHashMap<>();
        if (named) {
            members.put(DescriptionReader.TYPE, Descriptions.name(record.getClass()));
        }
        List<Object> usual = Descriptions.values(Descriptions.standard(record.getClass()));
        List<RecordComponent> components = Descriptions.components(record.getClass());
        for (int i = 0; i < usual.size(); i++) {
            Object value = Descriptions.value(components.get(i), record);
            if (!Descriptions.areEqual(value, usual.get(i))) {
                members.put(components.get(i).getName(), tree(components.get(i).getGenericType(), value));
            }
        }
        return members;
    }

    private static Object tree(Colour colour) {
        return Descriptions.areEqual(colour, Colour.grey(colour.red()))
                ? (Object) colour.red()
                : List.of(colour.red(), colour.green(), colour.blue());
    }

    private Object tree(Velocity velocity) {
        Object given = tree(Vector3dc.class, velocity.given());
        if (velocity.scale() == null) {
            return given;
        }
        Map<String, Object> members = new LinkedHashMap<>();
        members.put(velocity.scale().key(), velocity.value());
        members.put(VelocityReader.DIRECTION, given);
        return members;
    }

    private Object tree(FileContent content) {
        if (!embedded.test(content)) {
            return content.name();
        }
        Map<String, Object> members = new LinkedHashMap<>();
        members.put(FileContentReader.NAME, content.name());
        members.put(FileContentReader.BASE64, Base64.getEncoder().encodeToString(content.file()));
        return members;
    }
}
