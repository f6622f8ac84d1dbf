package tompkins.ui.editor;

import java.util.ArrayList;
import java.util.List;
import tompkins.property.Descriptions;
import tompkins.sceneobject.Hidden;
import tompkins.sceneobject.SceneObject;
import tompkins.ui.widget.Wording;

/** What the buttons of the editor do to a list: each change gives a new list. */
final class ListEdits {

    private ListEdits() {}

    static List<?> inserted(List<?> list, int place, Object element) {
        List<Object> copy = new ArrayList<>(list);
        copy.add(place, element);
        return copy;
    }

    /** The list with a copy of an element after it; the copy of an object gets a name that no other element has. */
    static List<?> duplicated(List<?> list, int place) {
        return inserted(list, place + 1, copy(list.get(place), list));
    }

    /** The list in which the object at a place is hidden, or shown if it was hidden. */
    static List<?> hiddenOrShown(List<?> list, int place) {
        List<Object> copy = new ArrayList<>(list);
        copy.set(place, Hiding.hiddenOrShown((SceneObject) list.get(place)));
        return copy;
    }

    static List<?> removed(List<?> list, int place) {
        List<Object> copy = new ArrayList<>(list);
        copy.remove(place);
        return copy;
    }

    static List<?> moved(List<?> list, int from, int to) {
        List<Object> copy = new ArrayList<>(list);
        copy.add(to, copy.remove(from));
        return copy;
    }

    private static Object copy(Object element, List<?> list) {
        if (!(element instanceof SceneObject object)) {
            return element;
        }
        List<String> taken = list.stream().map(Wording::nameOf).toList();
        String name = object.description().replaceFirst(" \\d+$", "");
        int number = 2;
        while (taken.contains(name + " " + number)) {
            number++;
        }
        return renamed(object, name + " " + number);
    }

    private static SceneObject renamed(SceneObject object, String name) {
        return object instanceof Hidden hidden
                ? new Hidden(renamed(hidden.object(), name))
                : Descriptions.with(object, "description", name);
    }
}
