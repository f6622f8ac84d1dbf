package tompkins.ui;

import javax.swing.JComponent;

/** Controls for one value of a description. They give new values to whoever made them. */
interface ValueEditor {

    /** The controls. */
    JComponent component();

    /** Shows a value. */
    void show(Object value);
}
