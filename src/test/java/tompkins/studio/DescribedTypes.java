package tompkins.studio;

import java.lang.reflect.RecordComponent;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import tompkins.property.Descriptions;

/** The types of descriptions that occur in studios, however deep. */
public final class DescribedTypes {

    private DescribedTypes() {}

    /** Those of some studios. */
    public static Set<Class<?>> in(Stream<Studio> studios) {
        Set<Class<?>> types = new HashSet<>();
        studios.forEach(studio -> addTo(types, studio));
        return types;
    }

    private static void addTo(Set<Class<?>> types, Object value) {
        if (value instanceof List<?> list) {
            list.forEach(element -> addTo(types, element));
        } else if (value instanceof Record) {
            types.add(value.getClass());
            for (RecordComponent component : Descriptions.components(value.getClass())) {
                addTo(types, Descriptions.value(component, value));
            }
        }
    }
}
