package tompkins.io;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.BiFunction;
import java.util.stream.IntStream;
import tompkins.io.JsonValue.JsonFlag;
import tompkins.io.JsonValue.JsonList;
import tompkins.io.JsonValue.JsonNumber;
import tompkins.io.JsonValue.JsonObject;
import tompkins.io.JsonValue.JsonText;
import tompkins.io.JsonValue.Member;

/** Checks values against a JSON schema, as far as the schema of scene files goes; refuses keywords that it does not know. */
final class SchemaCheck {

    private final JsonObject root;

    /** What a keyword finds wrong: nothing, or a list of mistakes. */
    private final Map<String, Keyword> keywords = Map.ofEntries(
            Map.entry("type", (rule, value, path) -> wrongIf(!isOfType(text(rule), value), path, "type")),
            Map.entry("const", (rule, value, path) -> wrongIf(!isEqual(rule, value), path, "const")),
            Map.entry(
                    "enum",
                    (rule, value, path) -> wrongIf(
                            ((JsonList) rule).values().stream().noneMatch(each -> isEqual(each, value)), path, "enum")),
            Map.entry("minimum", number((limit, number) -> number >= limit)),
            Map.entry("maximum", number((limit, number) -> number <= limit)),
            Map.entry("exclusiveMinimum", number((limit, number) -> number > limit)),
            Map.entry("exclusiveMaximum", number((limit, number) -> number < limit)),
            Map.entry("minItems", number((limit, size) -> size >= limit)),
            Map.entry("maxItems", number((limit, size) -> size <= limit)),
            Map.entry("items", this::items),
            Map.entry("properties", this::properties),
            Map.entry("required", (rule, value, path) -> ((JsonList) rule)
                    .values().stream()
                            .filter(key -> value instanceof JsonObject object
                                    && !object.members().containsKey(text(key)))
                            .map(key -> path + ": required " + text(key))
                            .toList()),
            Map.entry("allOf", (rule, value, path) -> ((JsonList) rule)
                    .values().stream()
                            .flatMap(each -> check((JsonObject) each, value, path).stream())
                            .toList()),
            Map.entry("anyOf", (rule, value, path) -> wrongIf(matching(rule, value) == 0, path, "anyOf")),
            Map.entry("oneOf", (rule, value, path) -> wrongIf(matching(rule, value) != 1, path, "oneOf")));

    /** A keyword of schemas. */
    private interface Keyword {

        List<String> check(JsonValue rule, JsonValue value, String path);
    }

    /** Keywords that check nothing by themselves. */
    private static final List<String> NOTES = List.of(
            "$schema",
            "title",
            "description",
            "default",
            "definitions",
            "enumDescriptions",
            "allowComments",
            "allowTrailingCommas",
            "additionalProperties",
            "then");

    SchemaCheck(String schema) {
        root = JsonParsing.parse(schema, new Problems("schema"));
    }

    /** What is wrong with the text of a scene, each with its place. */
    List<String> check(String scene) {
        return check(root, JsonParsing.parse(scene, new Problems("scene")), "");
    }

    /** What is wrong with a value of a key of a type. */
    List<String> check(String type, String key, String value) {
        JsonObject wanted = (JsonObject) at((JsonObject) at((JsonObject) at(root, "definitions"), type), "properties");
        JsonObject held = JsonParsing.parse("{\"value\": " + value + "}", new Problems("value"));
        return check((JsonObject) at(wanted, key), at(held, "value"), key);
    }

    private List<String> check(JsonObject schema, JsonValue value, String path) {
        List<String> wrong = new ArrayList<>();
        for (Map.Entry<String, Member> entry : schema.members().entrySet()) {
            JsonValue rule = entry.getValue().value();
            String keyword = entry.getKey();
            if (keyword.equals("$ref")) {
                String name = text(rule).replace("#/definitions/", "");
                wrong.addAll(check((JsonObject) at((JsonObject) at(root, "definitions"), name), value, path));
            } else if (keyword.equals("if")) {
                if (check((JsonObject) rule, value, path).isEmpty()) {
                    wrong.addAll(check((JsonObject) at(schema, "then"), value, path));
                }
            } else if (!NOTES.contains(keyword)) {
                wrong.addAll(keywords.get(keyword).check(rule, value, path));
            }
        }
        if (schema.members().containsKey("additionalProperties") && value instanceof JsonObject object) {
            JsonObject known = (JsonObject) at(schema, "properties");
            object.members().keySet().stream()
                    .filter(key -> !known.members().containsKey(key))
                    .forEach(key -> wrong.add(path + ": unknown " + key));
        }
        return wrong;
    }

    private List<String> items(JsonValue rule, JsonValue value, String path) {
        List<JsonValue> all = value instanceof JsonList list ? list.values() : List.of();
        return IntStream.range(0, all.size())
                .boxed()
                .flatMap(i -> check((JsonObject) rule, all.get(i), path + "[" + i + "]").stream())
                .toList();
    }

    private List<String> properties(JsonValue rule, JsonValue value, String path) {
        Map<String, Member> known = ((JsonObject) rule).members();
        Map<String, Member> all = value instanceof JsonObject object ? object.members() : Map.of();
        return all.entrySet().stream()
                .filter(member -> known.containsKey(member.getKey()))
                .flatMap(member -> check(
                        (JsonObject) known.get(member.getKey()).value(),
                        member.getValue().value(),
                        path + "." + member.getKey())
                        .stream())
                .toList();
    }

    private long matching(JsonValue rule, JsonValue value) {
        return ((JsonList) rule)
                .values().stream()
                        .filter(each -> check((JsonObject) each, value, "").isEmpty())
                        .count();
    }

    private static Keyword number(BiFunction<Double, Double, Boolean> holds) {
        return (rule, value, path) -> {
            Double number = value instanceof JsonNumber written
                    ? (Double) Double.parseDouble(written.text())
                    : value instanceof JsonList list ? (Double) (double) list.values().size() : null;
            double limit = Double.parseDouble(((JsonNumber) rule).text());
            return wrongIf(number != null && !holds.apply(limit, number), path, "number");
        };
    }

    private static List<String> wrongIf(boolean isWrong, String path, String what) {
        return isWrong ? List.of(path + ": " + what) : List.of();
    }

    private static JsonValue at(JsonObject object, String key) {
        return object.members().get(key).value();
    }

    private static String text(JsonValue value) {
        return ((JsonText) value).text();
    }

    private static boolean isEqual(JsonValue rule, JsonValue value) {
        if (rule instanceof JsonNumber number && value instanceof JsonNumber other) {
            return Double.parseDouble(number.text()) == Double.parseDouble(other.text());
        }
        return rule instanceof JsonText word && value instanceof JsonText other && word.text().equals(other.text());
    }

    private static boolean isOfType(String type, JsonValue value) {
        return switch (type) {
            case "object" -> value instanceof JsonObject;
            case "array" -> value instanceof JsonList;
            case "string" -> value instanceof JsonText;
            case "boolean" -> value instanceof JsonFlag;
            case "number" -> value instanceof JsonNumber;
            case "integer" ->
                value instanceof JsonNumber number
                        && Double.parseDouble(number.text()) == Math.rint(Double.parseDouble(number.text()));
            default -> throw new IllegalArgumentException(type);
        };
    }
}
