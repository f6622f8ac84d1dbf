package tompkins.ui.editor;

import java.util.List;
import tompkins.property.Descriptions;
import tompkins.sceneobject.Hidden;
import tompkins.sceneobject.SceneObject;
import tompkins.studio.StudioPath;

/** Objects that are hidden: the editor shows them as if they were not, so that they can be edited all the same. */
final class Hiding {

    private Hiding() {}

    /** What is hidden, or the value itself if it is not hidden. */
    static Object content(Object value) {
        return value instanceof Hidden hidden ? content(hidden.object()) : value;
    }

    /** The way to the {@link #content(Object)} of a value to which a path leads. */
    static StudioPath content(StudioPath path, Object value) {
        return value instanceof Hidden hidden ? content(path.then("object"), hidden.object()) : path;
    }

    /** The types that can be chosen from a family; hiding is left to a button. */
    static List<Class<?>> types(Class<?> family) {
        return Descriptions.members(family).stream()
                .filter(type -> type != Hidden.class)
                .toList();
    }

    /** The object if it was hidden, and hidden if it was not. */
    static SceneObject hiddenOrShown(SceneObject object) {
        return object instanceof Hidden hidden ? hidden.object() : new Hidden(object);
    }

    /** The object with another name, hidden if it was hidden. */
    static SceneObject renamed(SceneObject object, String name) {
        return object instanceof Hidden hidden
                ? new Hidden(renamed(hidden.object(), name))
                : Descriptions.with(object, "description", name);
    }
}
