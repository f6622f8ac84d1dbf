package tompkins.ui.editor;

import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.HashSet;
import java.util.Set;
import tompkins.property.Descriptions;

/**
 * Decides what the tree of the studio shows as branches and what a form shows: branches are lists, and whatever may
 * hold lists at any depth, such as groups of objects.
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
        if (!(type instanceof Class<?> plain) || !Descriptions.isDescription(plain) || !asked.add(type)) {
            return false;
        }
        return Descriptions.members(plain).stream()
                .flatMap(each -> Descriptions.components(each).stream())
                .map(RecordComponent::getGenericType)
                .anyMatch(part -> holdsLists(part, asked));
    }

    /** Whether a type is a list. */
    static boolean isList(Type type) {
        return Descriptions.elementType(type).isPresent();
    }
}
