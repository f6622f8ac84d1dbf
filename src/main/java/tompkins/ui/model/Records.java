package tompkins.ui.model;

import java.lang.reflect.RecordComponent;
import tompkins.property.Descriptions;

/** Changes descriptions part by part. */
public final class Records {

    private Records() {}

    /** The component of a record that has the given name. */
    public static RecordComponent component(Class<?> type, String name) {
        return Descriptions.components(type).stream()
                .filter(component -> component.getName().equals(name))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(type.getName() + " has no component " + name));
    }

    /**
     * The same record with another value of one component.
     *
     * @throws tompkins.property.InvalidPropertyException if the record does not accept it
     * @throws IllegalArgumentException if there is no such component
     */
    public static <R> R with(R holder, String name, Object value) {
        component(holder.getClass(), name);
        @SuppressWarnings("unchecked")
        Class<R> type = (Class<R>) holder.getClass();
        Object[] values = Descriptions.components(type).stream()
                .map(component -> component.getName().equals(name) ? value : Descriptions.value(component, holder))
                .toArray();
        return Descriptions.make(type, values);
    }

    /** Whether a type is a record or a sealed family of records. */
    public static boolean isDescription(Class<?> type) {
        // an enum whose values have code of their own counts as sealed, too
        return type.isRecord() || type.isSealed() && !type.isEnum();
    }
}
