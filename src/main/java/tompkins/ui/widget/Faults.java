package tompkins.ui.widget;

import javax.swing.SwingUtilities;

/** Faults of the program that must not stop what is under way. */
public final class Faults {

    private Faults() {}

    /** Throws a fault again after what is under way, where nobody but the handler of uncaught errors hears it. */
    public static void tell(RuntimeException fault) {
        SwingUtilities.invokeLater(() -> {
            throw fault;
        });
    }
}
