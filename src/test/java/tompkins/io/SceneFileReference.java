package tompkins.io;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.lang.reflect.AnnotatedElement;
import java.lang.reflect.RecordComponent;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import tompkins.property.Descriptions;
import tompkins.property.Meaning;
import tompkins.property.NumberText;
import tompkins.ray.MeshData;
import tompkins.ray.PixelPicture;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;

/** The reference of scene files, made from the types that they can name. */
public final class SceneFileReference {

    private static final String INTRODUCTION = "scene-files.md";

    /** A picture and a mesh that the scenes of the program use, for examples. */
    private static final String PICTURE = "pictures/clock.png";

    private static final String MESH = "meshes/trefoil.obj";

    private static final DescriptionWriter WRITER = new DescriptionWriter(picture -> false);

    private SceneFileReference() {}

    /** The reference as Markdown, with line feeds as line ends. */
    public static String markdown() {
        StringBuilder text = new StringBuilder(introduction());
        for (Class<?> type : sections()) {
            if (DescriptionTypes.isFamily(type)) {
                appendFamily(text, type);
            } else {
                String name = ValueKind.words(type.getSimpleName());
                text.append("\n## ").append(ValueKind.capitalised(name)).append("\n\n");
                text.append(meaning(type)).append(".\n");
                text.append(keys(type));
            }
        }
        return text.toString();
    }

    private static String introduction() {
        try (InputStream in = SceneFileReference.class.getResourceAsStream(INTRODUCTION)) {
            String text = new String(in.readAllBytes(), StandardCharsets.UTF_8).replace("\r\n", "\n");
            return text.replace("@SPEEDS@", speeds())
                    .replace("@LARGEST_GAMMA@", NumberText.of(Velocity.LARGEST_GAMMA))
                    .replace("@GUARANTEED_GAMMA@", NumberText.of(Velocity.GUARANTEED_GAMMA))
                    .replace("@LARGEST_MESH@", Integer.toString(MeshFile.LARGEST_KEPT_FILE >> 20))
                    .replace("@LARGEST_FILE@", Integer.toString(SceneText.LARGEST >> 20))
                    .replace("@MOST_VALUES@", Integer.toString(JsonParsing.MOST_VALUES))
                    .replace("@DEEPEST@", Integer.toString(JsonParsing.DEEPEST));
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }

    private static String speeds() {
        return Arrays.stream(SpeedScale.values())
                .map(scale -> "| `" + scale.key() + "` | " + meaning(scale) + " | " + scale.range() + " |")
                .collect(Collectors.joining("\n"));
    }

    private static String meaning(SpeedScale scale) {
        try {
            return meaning(SpeedScale.class.getField(scale.name()));
        } catch (NoSuchFieldException impossible) {
            throw new IllegalStateException(impossible);
        }
    }

    /** The studio, and everything that it can hold: families and single records, level by level. */
    private static Set<Class<?>> sections() {
        Set<Class<?>> found = new LinkedHashSet<>();
        Deque<Class<?>> open = new ArrayDeque<>(List.of(Studio.class));
        while (!open.isEmpty()) {
            Class<?> type = open.remove();
            if (found.add(type)) {
                List<Class<?>> records = DescriptionTypes.isFamily(type) ? Descriptions.members(type) : List.of(type);
                records.stream()
                        .flatMap(record -> Arrays.stream(record.getRecordComponents()))
                        .map(component -> Descriptions.elementType(component.getGenericType())
                                .orElse(component.getType()))
                        .filter(ValueKind::hasSection)
                        .forEach(open::add);
            }
        }
        return found;
    }

    /** The name of a type in scene files; in words where two families use one name. */
    static String heading(Class<?> type) {
        String name = Descriptions.name(type);
        String words = ValueKind.words(type.getSimpleName());
        return name.equals(type.getSimpleName()) ? name : ValueKind.capitalised(words);
    }

    private static void appendFamily(StringBuilder text, Class<?> family) {
        text.append("\n## ").append(ValueKind.title(family)).append("\n\n");
        Optional<Class<?>> usual = DescriptionTypes.usualMember(family);
        text.append(usual.map(type -> "Without a `\"type\"`, a `" + type.getSimpleName() + "`.")
                .orElse("The key `\"type\"` must be there."));
        text.append(" There are:\n\n");
        for (Class<?> type : Descriptions.members(family)) {
            String name = heading(type);
            text.append("- [")
                    .append(name)
                    .append("](#")
                    .append(ValueKind.anchor(name))
                    .append(")\n");
        }
        for (Class<?> type : Descriptions.members(family)) {
            text.append("\n### ").append(heading(type)).append("\n\n");
            text.append(meaning(type)).append(".\n");
            text.append(keys(type));
            text.append("\n```json\n").append(JsonLayout.text(example(type))).append("\n```\n");
        }
    }

    /** The table of the keys of a type; nothing if it has none. */
    static String keys(Class<?> type) {
        if (type.getRecordComponents().length == 0) {
            return "";
        }
        StringBuilder text =
                new StringBuilder("\n| key | value | meaning | unit | default |\n| --- | --- | --- | --- | --- |\n");
        Object standard = Descriptions.standard(type);
        for (RecordComponent component : type.getRecordComponents()) {
            Meaning meaning = component.getAnnotation(Meaning.class);
            text.append("| `").append(component.getName()).append("` | ");
            text.append(ValueKind.of(component)).append(" | ");
            text.append(meaning(component)).append(" | ");
            text.append(meaning.unit()).append(" | ");
            text.append(standard(component, standard)).append(" |\n");
        }
        return text.toString();
    }

    private static String standard(RecordComponent component, Object description) {
        Object value = Descriptions.value(component, description);
        if (value.equals(PixelPicture.WHITE)) {
            return "one white pixel";
        }
        return value.equals(MeshData.OCTAHEDRON)
                ? "an octahedron of radius 1"
                : "`" + JsonLayout.line(WRITER.tree(component.getGenericType(), value)) + "`";
    }

    private static String meaning(AnnotatedElement element) {
        Meaning meaning = element.getAnnotation(Meaning.class);
        if (meaning == null) {
            throw new IllegalStateException(element + " does not say what it means");
        }
        return meaning.value();
    }

    /** A type with the values of its default; names and what has a usual type are left out. */
    private static Map<String, Object> example(Class<?> type) {
        Map<String, Object> members = new LinkedHashMap<>();
        members.put(DescriptionReader.TYPE, Descriptions.name(type));
        Object standard = Descriptions.standard(type);
        for (RecordComponent component : type.getRecordComponents()) {
            Class<?> kind = component.getType();
            boolean usual = DescriptionTypes.isFamily(kind)
                    && DescriptionTypes.usualMember(kind).isPresent();
            if (kind != String.class && !usual) {
                members.put(component.getName(), example(component, standard));
            }
        }
        return members;
    }

    private static Object example(RecordComponent component, Object description) {
        if (component.getType() == PixelPicture.class) {
            return PICTURE;
        }
        if (component.getType() == MeshData.class) {
            return MESH;
        }
        Object value = Descriptions.value(component, description);
        Optional<Class<?>> element = Descriptions.elementType(component.getGenericType());
        if (element.isPresent() && ((List<?>) value).isEmpty()) {
            String first = DescriptionTypes.memberNames(element.get()).get(0);
            return List.of(Map.of(DescriptionReader.TYPE, first));
        }
        return WRITER.tree(component.getGenericType(), value);
    }
}
