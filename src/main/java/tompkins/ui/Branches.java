package tompkins.ui;

import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * Tells what a tree of the studio shows as branches from what a form shows: branches are lists, and whatever may hold lists
 * at any depth, such as groups of objects.
 */
final class Branches {

    private Branches() {}

    /** Whether values of a type are branches. */
    static boolean isBranch(Type type) {
        return holdsLists(type, new HashSet<>());
    }

    private static boolean holdsLists(Type type, Set<Type> asked) {
        if (isList(type)) {
            return true;
        }
        if (!(type instanceof Class<?> plain) || !Records.isDescription(plain) || !asked.add(type)) {
            return false;
        }
        return Records.records(plain).stream()
                .flatMap(each -> Arrays.stream(each.getRecordComponents()))
                .map(RecordComponent::getGenericType)
                .anyMatch(part -> holdsLists(part, asked));
    }

    /** Whether a type is a list. */
    static boolean isList(Type type) {
        return type instanceof ParameterizedType generic && generic.getRawType() == List.class;
    }

    /** The type of the elements of a list. */
    static Class<?> elementType(Type list) {
        return (Class<?>) ((ParameterizedType) list).getActualTypeArguments()[0];
    }
}
