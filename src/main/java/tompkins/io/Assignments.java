package tompkins.io;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.joml.Vector2ic;
import tompkins.io.JsonValue.JsonChange;
import tompkins.io.JsonValue.JsonFlag;
import tompkins.io.JsonValue.JsonList;
import tompkins.io.JsonValue.JsonNull;
import tompkins.io.JsonValue.JsonNumber;
import tompkins.io.JsonValue.JsonObject;
import tompkins.io.JsonValue.JsonText;
import tompkins.io.JsonValue.Member;
import tompkins.property.MistakeException;
import tompkins.property.NumberText;
import tompkins.studio.FrontWindow;
import tompkins.studio.Studio;
import tompkins.studio.StudioPath;

/** Changes single values of a studio, with the checks and the messages of scene files. */
public final class Assignments {

    private static final String EXAMPLES = "such as settings.width, velocity.gamma or scene[0].radius";

    private Assignments() {}

    /**
     * The studio with other values. All are given together, so that their order does not matter: a width that is too
     * large for the present height may come with a smaller height. A window in front of the lens that has the velocity
     * of the camera keeps it, unless what moves with the camera is changed, too.
     *
     * @param folder where pictures and meshes are that the values name
     * @throws MistakeException if a value is refused; its mistakes have the options in the place of the file
     */
    public static Studio applyTo(Studio studio, List<Assignment> assignments, Path folder) {
        if (assignments.isEmpty()) {
            return studio;
        }
        Studio changed = changed(studio, assignments, folder);
        boolean isWindowSet = assignments.stream().anyMatch(each -> each.path().startsWith("cameraFrame"));
        return isWindowSet ? changed : FrontWindow.following(studio, changed);
    }

    /** The end of a message about an option that is none, if a key of a scene has its name. */
    public static String hint(String key) {
        return DescriptionReader.part(key, Studio.DEFAULT)
                .map(path -> Spelling.meant("--set " + path + "=VALUE"))
                .orElse("");
    }

    /** As above, for any description, and without a window. */
    static <R extends Record> R changed(R description, List<Assignment> assignments, Path folder) {
        Problems problems =
                new Problems(assignments.stream().map(Assignment::option).toList());
        Map<String, Member> parts = new LinkedHashMap<>();
        for (int i = 0; i < assignments.size(); i++) {
            add(parts, assignments, i, description, problems);
        }
        problems.throwIfAny();
        DescriptionReader reader = new DescriptionReader(problems, new SceneFolder(folder));
        Object changed = reader.record(description.getClass(), new JsonObject(1, 0, parts), "", List.of(), description);
        problems.throwIfAny();
        @SuppressWarnings("unchecked")
        R result = (R) changed;
        return result;
    }

    private static void add(
            Map<String, Member> parts, List<Assignment> assignments, int index, Record whole, Problems problems) {
        Assignment assignment = assignments.get(index);
        int number = index + 1;
        StudioPath path = StudioPath.parse(assignment.path()).orElse(StudioPath.ROOT);
        List<Object> steps = path.steps();
        if (steps.isEmpty()) {
            problems.add(
                    number,
                    0,
                    "",
                    "must begin with the path of a key, " + EXAMPLES + ", was "
                            + Problems.shortened(assignment.path()));
            return;
        }
        Map<String, Member> inner = parts;
        for (int i = 0; i < steps.size(); i++) {
            String key = steps.get(i) instanceof Integer place ? "[" + place + "]" : (String) steps.get(i);
            boolean last = i == steps.size() - 1;
            Member known = inner.get(key);
            if (known != null && (last || !(known.value() instanceof JsonChange))) {
                String other = assignments.get(known.line() - 1).option();
                problems.add(number, 0, assignment.path(), "is already given by " + other);
                return;
            }
            if (known == null) {
                JsonValue value = last
                        ? value(assignment, isPair(path, whole), problems, number)
                        : new JsonChange(new JsonObject(number, 0, new LinkedHashMap<>()));
                known = new Member(number, 0, value);
                inner.put(key, known);
            }
            inner = known.value() instanceof JsonChange change ? change.parts().members() : Map.of();
        }
    }

    /** Whether two numbers belong at the end of a path, so that a comma stands between them. */
    private static boolean isPair(StudioPath path, Record whole) {
        return path.length(whole) == path.steps().size() && path.get(whole) instanceof Vector2ic;
    }

    private static JsonValue value(Assignment assignment, boolean isPair, Problems problems, int number) {
        String text = assignment.value().strip();
        if (text.startsWith("{") || text.startsWith("[") || text.startsWith("\"")) {
            return JsonParsing.parseValue(text, assignment.path(), problems, number);
        }
        if (isNumber(text) && !(isPair && text.contains(","))) {
            return new JsonNumber(number, 0, NumberText.withPoint(text));
        }
        String[] parts = text.split(",", -1);
        if (parts.length > 1 && Stream.of(parts).allMatch(Assignments::isNumber)) {
            return new JsonList(
                    number,
                    0,
                    Stream.of(parts)
                            .<JsonValue>map(part -> new JsonNumber(number, 0, part.strip()))
                            .toList());
        }
        return switch (text) {
            case "true", "false" -> new JsonFlag(number, 0, text.equals("true"));
            case "null" -> new JsonNull(number, 0);
            default -> new JsonText(number, 0, text);
        };
    }

    private static boolean isNumber(String text) {
        try {
            NumberText.parse(text);
            return true;
        } catch (NumberFormatException word) {
            return false;
        }
    }
}
