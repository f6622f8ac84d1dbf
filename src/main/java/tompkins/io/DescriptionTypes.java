package tompkins.io;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import tompkins.camera.ThinLensCamera;
import tompkins.property.InvalidPropertyException;
import tompkins.studio.UniformBackground;
import tompkins.surface.ColouredSurface;

/** What the records that describe a scene say of themselves: components, defaults, families. */
final class DescriptionTypes {

    /** The members of families that are meant where a scene file does not name a type. */
    private static final Set<Class<?>> USUAL =
            Set.of(ThinLensCamera.class, ColouredSurface.class, UniformBackground.class);

    private DescriptionTypes() {}

    /** Whether a type is a family, whose members have a key {@code type} in scene files. */
    static boolean isFamily(Class<?> type) {
        return type.isInterface() && type.isSealed();
    }

    /** The records of a family, in the order of its declaration. */
    static List<Class<?>> members(Class<?> family) {
        return Arrays.stream(family.getPermittedSubclasses())
                .flatMap(type -> isFamily(type) ? members(type).stream() : Stream.of(type))
                .toList();
    }

    /** The names of the records of a family. */
    static List<String> memberNames(Class<?> family) {
        return members(family).stream().<String>map(Class::getSimpleName).toList();
    }

    /** The record of a family that is meant where none is named. */
    static Optional<Class<?>> usualMember(Class<?> family) {
        return members(family).stream().filter(USUAL::contains).findFirst();
    }

    /** The keys of a record. */
    static List<String> keys(Class<?> type) {
        return Arrays.stream(type.getRecordComponents())
                .map(RecordComponent::getName)
                .toList();
    }

    /** The constant {@code DEFAULT} of a record. */
    static Object standard(Class<?> type) {
        try {
            return type.getField("DEFAULT").get(null);
        } catch (ReflectiveOperationException missing) {
            throw new IllegalStateException(type + " has no DEFAULT", missing);
        }
    }

    /** The value of a component. */
    static Object value(RecordComponent component, Object description) {
        try {
            return component.getAccessor().invoke(description);
        } catch (ReflectiveOperationException hidden) {
            throw new IllegalStateException(component + " cannot be read", hidden);
        }
    }

    /**
     * A new record.
     *
     * @throws InvalidPropertyException if its constructor refuses a value
     */
    static Object make(Class<?> type, Object... values) {
        Class<?>[] types = Arrays.stream(type.getRecordComponents())
                .map(RecordComponent::getType)
                .toArray(Class<?>[]::new);
        try {
            return type.getConstructor(types).newInstance(values);
        } catch (InvocationTargetException refused) {
            if (refused.getCause() instanceof RuntimeException exception) {
                throw exception;
            }
            throw new IllegalStateException(type + " cannot be made", refused);
        } catch (ReflectiveOperationException hidden) {
            throw new IllegalStateException(type + " cannot be made", hidden);
        }
    }

    /** The type of the elements if a type is a list. */
    static Optional<Class<?>> elementType(Type type) {
        return type instanceof ParameterizedType generic && generic.getRawType() == List.class
                ? Optional.of((Class<?>) generic.getActualTypeArguments()[0])
                : Optional.empty();
    }

    /** The name of a constant in scene files: lower case, with hyphens. */
    static String constantName(Object constant) {
        return ((Enum<?>) constant).name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** The names of all constants of an enumeration. */
    static List<String> constantNames(Class<?> type) {
        return Arrays.stream(type.getEnumConstants())
                .map(DescriptionTypes::constantName)
                .toList();
    }
}
