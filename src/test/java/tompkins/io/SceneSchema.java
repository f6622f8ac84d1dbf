package tompkins.io;

import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.joml.Vector2ic;
import org.joml.Vector3dc;
import org.joml.Vector3ic;
import tompkins.camera.ThinLensCamera;
import tompkins.property.Descriptions;
import tompkins.property.Meaning;
import tompkins.ray.Colour;
import tompkins.ray.FileContent;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;

/** Makes the JSON schema of scene files, in the draft that text editors know best, from the descriptions themselves. */
final class SceneSchema {

    private static final String NUMBER = "(-?[0-9.]+(?:e-?[0-9]+)?)";

    /** What a refusal says is allowed, and the keywords for the numbers in it. */
    private static final Map<Pattern, List<String>> RANGES = Map.of(
            Pattern.compile("from " + NUMBER + " to " + NUMBER), List.of("minimum", "maximum"),
            Pattern.compile("a whole number from " + NUMBER + " to " + NUMBER), List.of("minimum", "maximum"),
            Pattern.compile("a finite number above " + NUMBER), List.of("exclusiveMinimum"),
            Pattern.compile("(?:a finite number, )?" + NUMBER + " or above"), List.of("minimum"),
            Pattern.compile("at least " + NUMBER + " and below " + NUMBER + " .*"),
                    List.of("minimum", "exclusiveMaximum"),
            Pattern.compile(NUMBER + " or above, and below " + NUMBER), List.of("minimum", "exclusiveMaximum"),
            Pattern.compile("(0)"), List.of("const"),
            Pattern.compile("above " + NUMBER + " and at most " + NUMBER), List.of("exclusiveMinimum", "maximum"),
            Pattern.compile("above " + NUMBER + " and below " + NUMBER),
                    List.of("exclusiveMinimum", "exclusiveMaximum"));

    private SceneSchema() {}

    /** The text of the schema. */
    static String text() {
        Map<String, Object> schema = new LinkedHashMap<>();
        schema.put("$schema", "http://json-schema.org/draft-07/schema#");
        schema.put("title", "Scene file of Tompkins");
        schema.put("allowComments", true);
        schema.put("allowTrailingCommas", true);
        schema.put("allOf", List.of(Map.of("$ref", reference(Studio.class))));
        Map<String, Object> definitions = new LinkedHashMap<>();
        for (Class<?> type : TypeReference.types()) {
            definitions.put(type.getSimpleName(), type.isRecord() ? record(type) : family(type));
        }
        schema.put("definitions", definitions);
        return JsonLayout.text(schema) + "\n";
    }

    private static String reference(Class<?> type) {
        return "#/definitions/" + type.getSimpleName();
    }

    private static Map<String, Object> record(Class<?> type) {
        Map<String, Object> properties = new LinkedHashMap<>();
        if (type == Studio.class) {
            properties.put(StudioReader.VERSION_KEY, Map.of("const", StudioReader.VERSION));
        }
        if (TypeReference.familyOf(type).isPresent()) {
            properties.put(DescriptionReader.TYPE, Map.of("const", Descriptions.name(type)));
        }
        for (RecordComponent component : Descriptions.components(type)) {
            properties.put(component.getName(), property(type, component));
        }
        return object(type.getAnnotation(Meaning.class).value() + ".", properties);
    }

    private static Map<String, Object> object(String description, Map<String, Object> properties) {
        Map<String, Object> object = new LinkedHashMap<>();
        object.put("description", description);
        object.put("type", "object");
        object.put("properties", properties);
        object.put("additionalProperties", false);
        return object;
    }

    /** The type names the member, whose own schema then says what is wrong with it: only one, and not one for each. */
    private static Map<String, Object> family(Class<?> family) {
        Map<String, Object> type = new LinkedHashMap<>();
        type.put("enum", DescriptionTypes.memberNames(family));
        type.put(
                "enumDescriptions",
                Descriptions.members(family).stream()
                        .map(member -> member.getAnnotation(Meaning.class).value() + ".")
                        .toList());
        Map<String, Object> schema = new LinkedHashMap<>();
        schema.put("type", "object");
        schema.put("properties", Map.of(DescriptionReader.TYPE, type));
        Optional<Class<?>> usual = DescriptionTypes.usualMember(family);
        usual.ifPresentOrElse(
                member -> type.put("default", Descriptions.name(member)),
                () -> schema.put("required", List.of(DescriptionReader.TYPE)));
        schema.put(
                "allOf",
                Descriptions.members(family).stream()
                        .map(member ->
                                member(member, usual.filter(member::equals).isPresent()))
                        .toList());
        return schema;
    }

    private static Map<String, Object> member(Class<?> member, boolean isUsual) {
        Map<String, Object> named = new LinkedHashMap<>();
        named.put("properties", Map.of(DescriptionReader.TYPE, Map.of("const", Descriptions.name(member))));
        if (!isUsual) {
            named.put("required", List.of(DescriptionReader.TYPE));
        }
        Map<String, Object> rule = new LinkedHashMap<>();
        rule.put("if", named);
        rule.put("then", Map.of("$ref", reference(member)));
        return rule;
    }

    private static Map<String, Object> property(Class<?> type, RecordComponent component) {
        Meaning meaning = component.getAnnotation(Meaning.class);
        String allowed = TypeReference.allowed(type, component);
        Map<String, Object> schema = new LinkedHashMap<>();
        schema.put(
                "description",
                meaning.value() + (meaning.unit().isEmpty() ? "" : "; unit: " + meaning.unit())
                        + (allowed.isEmpty() ? "" : "; " + allowed) + ".");
        boolean isDistance = type == ThinLensCamera.class && component.getName().equals("focus");
        if (isDistance) {
            schema.put("anyOf", List.of(value(component.getType()), Map.of("type", "number")));
        } else if (typeOfList(component).isPresent()) {
            schema.put("type", "array");
            schema.put("items", value(typeOfList(component).get()));
        } else {
            schema.putAll(value(component.getType()));
        }
        schema.putAll(range(allowed));
        Object standard = Descriptions.value(component, Descriptions.standard(type));
        if (!(standard instanceof FileContent)) {
            schema.put("default", new DescriptionWriter(file -> false).tree(component.getGenericType(), standard));
        }
        return schema;
    }

    private static Optional<Class<?>> typeOfList(RecordComponent component) {
        return Descriptions.elementType(component.getGenericType());
    }

    private static Map<String, Object> range(String allowed) {
        String[] parts = allowed.split(", or ");
        if (parts.length > 1) {
            return Map.of("anyOf", Stream.of(parts).map(SceneSchema::range).toList());
        }
        Map<String, Object> range = new LinkedHashMap<>();
        RANGES.forEach((pattern, keywords) -> {
            Matcher numbers = pattern.matcher(allowed);
            if (numbers.matches()) {
                for (int i = 0; i < keywords.size(); i++) {
                    range.put(keywords.get(i), Double.valueOf(numbers.group(i + 1)));
                }
            }
        });
        return range;
    }

    private static Map<String, Object> value(Class<?> type) {
        if (type == double.class) {
            return Map.of("type", "number");
        }
        if (type == int.class || type == long.class) {
            return Map.of("type", "integer");
        }
        if (type == boolean.class) {
            return Map.of("type", "boolean");
        }
        if (type == String.class) {
            return Map.of("type", "string");
        }
        if (type.isEnum()) {
            return Map.of("enum", DescriptionTypes.constantNames(type));
        }
        if (type == Vector3dc.class) {
            return numbers("number", 3);
        }
        if (type == Vector3ic.class || type == Vector2ic.class) {
            return numbers("integer", type == Vector3ic.class ? 3 : 2);
        }
        if (type == Colour.class) {
            return Map.of("anyOf", List.of(number(0), colour()));
        }
        if (type == Velocity.class) {
            return Map.of("anyOf", List.of(numbers("number", 3), velocity()));
        }
        if (FileContent.class.isAssignableFrom(type)) {
            Map<String, Object> text = Map.of("type", "string");
            Map<String, Object> held = new LinkedHashMap<>();
            held.put(FileContentReader.NAME, text);
            held.put(FileContentReader.BASE64, text);
            return Map.of("anyOf", List.of(text, object("A file with its bytes.", held)));
        }
        // beside a reference alone nothing else would count
        return Map.of("allOf", List.of(Map.of("$ref", reference(type))));
    }

    private static Map<String, Object> numbers(String type, int count) {
        Map<String, Object> list = new LinkedHashMap<>();
        list.put("type", "array");
        list.put("items", Map.of("type", type));
        list.put("minItems", count);
        list.put("maxItems", count);
        return list;
    }

    private static Map<String, Object> colour() {
        Map<String, Object> colour = numbers("number", 3);
        colour.put("items", number(0));
        return colour;
    }

    private static Map<String, Object> number(int minimum) {
        Map<String, Object> number = new LinkedHashMap<>();
        number.put("type", "number");
        number.put("minimum", minimum);
        return number;
    }

    private static Map<String, Object> velocity() {
        Map<String, Object> properties = new LinkedHashMap<>();
        for (SpeedScale scale : SpeedScale.values()) {
            Map<String, Object> number = new LinkedHashMap<>();
            number.put("description", meaning(scale) + "; " + scale.range() + ".");
            number.put("type", "number");
            number.putAll(range(scale.range()));
            properties.put(scale.key(), number);
        }
        properties.put(VelocityReader.DIRECTION, numbers("number", 3));
        Map<String, Object> velocity = object("A speed, given in one of four ways, and its direction.", properties);
        velocity.put(
                "oneOf",
                Arrays.stream(SpeedScale.values())
                        .map(scale -> Map.of("required", List.of(scale.key())))
                        .toList());
        return velocity;
    }

    private static String meaning(SpeedScale scale) {
        try {
            return SpeedScale.class
                    .getField(scale.name())
                    .getAnnotation(Meaning.class)
                    .value();
        } catch (NoSuchFieldException impossible) {
            throw new IllegalStateException(impossible);
        }
    }
}
