package tompkins.property;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * Reads, builds and changes descriptions without knowing them: they are records, sealed families of records, and lists
 * of both. A new one needs no line in scene files or in the editor.
 */
public final class Descriptions {

    private static final ClassValue<List<RecordComponent>> COMPONENTS =
            cachedPerClass(type -> List.of(type.getRecordComponents()));

    private static final ClassValue<Constructor<?>> CONSTRUCTOR = cachedPerClass(Descriptions::constructor);

    private static final ClassValue<Standard> STANDARD = cachedPerClass(Descriptions::readStandard);

    private static final ClassValue<List<Class<?>>> MEMBERS = cachedPerClass(Descriptions::readMembers);

    /** The usual description of a type, null if there is none, and the values of its components. */
    private record Standard(Object description, List<Object> values) {}

    private Descriptions() {}

    /** What is asked of a type once and then kept. */
    public static <T> ClassValue<T> cachedPerClass(Function<Class<?>, T> answer) {
        return new ClassValue<>() {
            @Override
            protected T computeValue(Class<?> type) {
                return answer.apply(type);
            }
        };
    }

    /** What scene files call a record type. */
    public static String name(Class<?> type) {
        TypeName name = type.getAnnotation(TypeName.class);
        return name == null ? type.getSimpleName() : name.value();
    }

    /** The components of a record type, in their order. */
    public static List<RecordComponent> components(Class<?> type) {
        return COMPONENTS.get(type);
    }

    /** The component of a record type that has the given name, if there is one. */
    public static Optional<RecordComponent> find(Class<?> type, String name) {
        return components(type).stream()
                .filter(component -> component.getName().equals(name))
                .findFirst();
    }

    /**
     * The component of a record type that has the given name.
     *
     * @throws IllegalArgumentException if there is none
     */
    public static RecordComponent component(Class<?> type, String name) {
        return find(type, name)
                .orElseThrow(() -> new IllegalArgumentException(type.getName() + " has no component " + name));
    }

    /** The names of the components of a record type that are {@linkplain Meaning#place places}. */
    public static List<String> places(Class<?> type) {
        return components(type).stream()
                .filter(component -> component.isAnnotationPresent(Meaning.class)
                        && component.getAnnotation(Meaning.class).place())
                .map(RecordComponent::getName)
                .toList();
    }

    /** The value of a component. */
    public static Object value(RecordComponent component, Object description) {
        try {
            return component.getAccessor().invoke(description);
        } catch (ReflectiveOperationException hidden) {
            throw new IllegalStateException(component + " cannot be read", hidden);
        }
    }

    /** The values of all components, in their order. */
    public static List<Object> values(Object description) {
        Standard standard = STANDARD.get(description.getClass());
        return description == standard.description ? standard.values : readValues(description);
    }

    /** The elements of a list, or the values of all components of a record; nothing else has parts. */
    public static List<?> parts(Object value) {
        return value instanceof List<?> list ? list : value instanceof Record ? values(value) : List.of();
    }

    /**
     * Whether two values of a component are equal; records are compared component by component. Java's own comparison
     * makes code for each type of records when it is first used, which makes the start of the program longer.
     */
    public static boolean areEqual(Object first, Object second) {
        if (first == second) {
            return true;
        }
        boolean isList = first instanceof List && second instanceof List;
        if (!isList && !(first instanceof Record && first.getClass() == second.getClass())) {
            return !(first instanceof Record) && first.equals(second);
        }
        List<?> ours = parts(first);
        List<?> others = parts(second);
        boolean equal = ours.size() == others.size();
        for (int i = 0; equal && i < ours.size(); i++) {
            equal = areEqual(ours.get(i), others.get(i));
        }
        return equal;
    }

    private static List<Object> readValues(Object description) {
        List<RecordComponent> components = components(description.getClass());
        Object[] values = new Object[components.size()];
        for (int i = 0; i < values.length; i++) {
            values[i] = value(components.get(i), description);
        }
        return Collections.unmodifiableList(Arrays.asList(values));
    }

    /**
     * A record from the values of its components, none of which is null.
     *
     * @throws InvalidPropertyException if the record does not accept them
     */
    public static <R> R make(Class<R> type, Object... values) {
        for (int i = 0; i < values.length; i++) {
            Require.present(components(type).get(i).getName(), values[i]);
        }
        try {
            return type.cast(CONSTRUCTOR.get(type).newInstance(values));
        } catch (InvocationTargetException refused) {
            if (refused.getCause() instanceof RuntimeException exception) {
                throw exception;
            }
            throw new IllegalStateException(type + " cannot be made", refused);
        } catch (ReflectiveOperationException hidden) {
            throw new IllegalStateException(type + " cannot be made", hidden);
        }
    }

    private static Constructor<?> constructor(Class<?> type) {
        try {
            return type.getConstructor(
                    components(type).stream().map(RecordComponent::getType).toArray(Class<?>[]::new));
        } catch (NoSuchMethodException hidden) {
            throw new IllegalStateException(type + " cannot be made", hidden);
        }
    }

    /**
     * The same record with another value of one component.
     *
     * @throws InvalidPropertyException if the record does not accept it
     * @throws IllegalArgumentException if there is no such component
     */
    public static <R> R with(R record, String name, Object value) {
        component(record.getClass(), name);
        return changed(record, (component, before) -> component.equals(name) ? value : before);
    }

    /**
     * The same record with other values.
     *
     * @param change gives the new value of a component from its name and its value
     * @throws InvalidPropertyException if the record does not accept them
     */
    public static <R> R changed(R record, BiFunction<String, Object, Object> change) {
        @SuppressWarnings("unchecked")
        Class<R> type = (Class<R>) record.getClass();
        Object[] values = components(type).stream()
                .map(component -> change.apply(component.getName(), value(component, record)))
                .toArray();
        return make(type, values);
    }

    /** The constant {@code DEFAULT} of a record type, from which a new description starts. */
    public static Object standard(Class<?> type) {
        Object standard = STANDARD.get(type).description;
        if (standard == null) {
            throw new IllegalStateException(type + " has no DEFAULT");
        }
        return standard;
    }

    private static Standard readStandard(Class<?> type) {
        try {
            Object standard = type.getField("DEFAULT").get(null);
            return new Standard(standard, readValues(standard));
        } catch (ReflectiveOperationException missing) {
            return new Standard(null, List.of());
        }
    }

    /** Whether a type is a record or a sealed family of records. */
    public static boolean isDescription(Class<?> type) {
        // an enum whose values have code of their own counts as sealed, too
        return type.isRecord() || type.isSealed() && !type.isEnum();
    }

    /**
     * The records of a sealed family, in the order in which it names them, with those that other jars add; the type
     * itself if it is a record.
     *
     * @throws MistakeException if a jar adds what cannot be used
     */
    public static List<Class<?>> members(Class<?> family) {
        return MEMBERS.get(family);
    }

    private static List<Class<?>> readMembers(Class<?> family) {
        if (family.isRecord()) {
            return List.of(family);
        }
        List<Class<?>> members = Arrays.stream(family.getPermittedSubclasses())
                .<Class<?>>flatMap(type -> type.isSealed()
                        ? members(type).stream()
                        : type.isInterface() ? AddedTypes.of(type).stream() : Stream.of(type))
                .toList();
        AddedTypes.requireDistinct(members);
        return members;
    }

    /** The type of the elements if a type is a list. */
    public static Optional<Class<?>> elementType(Type type) {
        return type instanceof ParameterizedType generic && generic.getRawType() == List.class
                ? Optional.of((Class<?>) generic.getActualTypeArguments()[0])
                : Optional.empty();
    }
}
