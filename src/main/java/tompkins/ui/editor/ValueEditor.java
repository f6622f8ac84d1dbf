package tompkins.ui.editor;

import java.util.Optional;
import javax.swing.JComponent;

/** Controls for one value of a description. They give new values to the code that made them. */
interface ValueEditor {

    /** The controls. */
    JComponent component();

    /** Controls of its parts, which stand under the others and need the whole width of a form. */
    default Optional<JComponent> parts() {
        return Optional.empty();
    }

    /** Whether the controls take several lines, so that their label is placed beside the first. */
    default boolean isTall() {
        return false;
    }

    /** Shows a value. */
    void show(Object value);
}
