package tompkins.io;

import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import tompkins.property.Descriptions;
import tompkins.property.NumberText;
import tompkins.ray.Colour;
import tompkins.spacetime.Velocity;

/** What has to be assigned to one description to make another one of it. */
public final class Differences {

    private final List<Assignment> found = new ArrayList<>();
    private boolean isInFiles;
    private final DescriptionWriter writer = new DescriptionWriter(file -> isInFiles = true);

    private Differences() {}

    /**
     * The differences of two descriptions of one type, each an assignment that is called {@code --set}; empty if other
     * pictures or meshes belong to them, which no value can hold.
     */
    public static <R extends Record> Optional<List<Assignment>> between(R first, R second) {
        Differences differences = new Differences();
        differences.collect("", first.getClass(), first, second);
        return differences.isInFiles ? Optional.empty() : Optional.of(differences.found);
    }

    private void collect(String path, Type type, Object first, Object second) {
        if (second.equals(first)) {
            return;
        }
        if (first instanceof List<?> before && second instanceof List<?> now && before.size() == now.size()) {
            Type element = Descriptions.elementType(type).orElseThrow();
            for (int i = 0; i < now.size(); i++) {
                collect(path + "[" + i + "]", element, before.get(i), now.get(i));
            }
        } else if (second instanceof Velocity now && first instanceof Velocity before && isOnlySpeed(before, now)) {
            add(path + "." + now.scale().key(), NumberText.of(now.value()));
        } else if (second instanceof Record && !(second instanceof Colour)) {
            collectParts(path, first, second);
        } else {
            Object tree = writer.tree(type, second);
            add(path, tree instanceof String text && isWord(text) ? text : JsonLayout.line(tree));
        }
    }

    /** Another type is assigned first; what is not assigned then has the value of its default. */
    private void collectParts(String path, Object first, Object second) {
        Class<?> type = second.getClass();
        Object base = first;
        if (first.getClass() != type) {
            add(DescriptionReader.inner(path, DescriptionReader.TYPE), Descriptions.name(type));
            base = Descriptions.standard(type);
        }
        for (RecordComponent component : Descriptions.components(type)) {
            collect(
                    DescriptionReader.inner(path, component.getName()),
                    component.getGenericType(),
                    Descriptions.value(component, base),
                    Descriptions.value(component, second));
        }
    }

    private static boolean isOnlySpeed(Velocity before, Velocity now) {
        return now.scale() != null && now.givenDirection().equals(before.givenDirection());
    }

    private static boolean isWord(String text) {
        return text.matches("[a-z]+(-[a-z]+)*") && !text.matches("true|false|null");
    }

    private void add(String path, String value) {
        found.add(new Assignment("--set", path, value));
    }
}
