package tompkins.ui;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;

/** Reads and rebuilds descriptions without knowing them: they are records and sealed families of records. */
final class Records {

    /** Asking a class for its components takes microseconds, and scenes have many objects. */
    private static final ClassValue<List<RecordComponent>> COMPONENTS = new ClassValue<>() {
        @Override
        protected List<RecordComponent> computeValue(Class<?> type) {
            return List.of(type.getRecordComponents());
        }
    };

    private Records() {}

    /** The components of a record type, in their order. */
    static List<RecordComponent> components(Class<?> type) {
        return COMPONENTS.get(type);
    }

    /** The value of a component. */
    static Object get(Object holder, RecordComponent component) {
        try {
            return component.getAccessor().invoke(holder);
        } catch (IllegalAccessException | InvocationTargetException e) {
            throw new IllegalStateException(component.toString(), e);
        }
    }

    /** The component of a record that has the given name. */
    static RecordComponent component(Class<?> type, String name) {
        return components(type).stream()
                .filter(component -> component.getName().equals(name))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(type.getName() + " has no component " + name));
    }

    /**
     * The same record with another value of one component.
     *
     * @throws tompkins.property.InvalidPropertyException if the record does not accept it
     */
    static <R> R with(R holder, String name, Object value) {
        @SuppressWarnings("unchecked")
        Class<R> type = (Class<R>) holder.getClass();
        Object[] values = components(type).stream()
                .map(component -> component.getName().equals(name) ? value : get(holder, component))
                .toArray();
        return build(type, values);
    }

    /**
     * A record from the values of its components.
     *
     * @throws tompkins.property.InvalidPropertyException if the record does not accept them
     */
    static <R> R build(Class<R> type, Object... values) {
        Class<?>[] types =
                components(type).stream().map(RecordComponent::getType).toArray(Class<?>[]::new);
        try {
            Constructor<R> constructor = type.getDeclaredConstructor(types);
            return constructor.newInstance(values);
        } catch (InvocationTargetException e) {
            if (e.getCause() instanceof RuntimeException refused) {
                throw refused;
            }
            throw new IllegalStateException(type.getName(), e);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(type.getName(), e);
        }
    }

    /** Whether a type is a record or a sealed family of records. */
    static boolean isDescription(Class<?> type) {
        // an enum whose values have code of their own counts as sealed, too
        return type.isRecord() || type.isSealed() && !type.isEnum();
    }

    /** All records of a sealed family, in the order in which it names them; the type itself if it is a record. */
    static List<Class<?>> records(Class<?> family) {
        return family.isRecord() ? List.of(family) : permitted(family).toList();
    }

    private static Stream<Class<?>> permitted(Class<?> family) {
        return Arrays.stream(family.getPermittedSubclasses())
                .flatMap(type -> type.isSealed() ? permitted(type) : Stream.of(type));
    }

    /** The value with which a new description of a type starts. */
    static Object defaultOf(Class<?> type) {
        try {
            return type.getField("DEFAULT").get(null);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(type.getName(), e);
        }
    }
}
