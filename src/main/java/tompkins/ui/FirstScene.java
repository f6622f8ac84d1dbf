package tompkins.ui;

import java.awt.Component;
import java.nio.file.Path;
import tompkins.studio.Studio;
import tompkins.ui.widget.Messages;

/**
 * What a window shows first.
 *
 * @param studio the scene
 * @param file where it was read from, or null
 * @param problem why it is not the scene that was asked for; empty if it is
 */
public record FirstScene(Studio studio, Path file, String problem) {

    /** The scene that was asked for, from a file or, with null, from the program. */
    public FirstScene(Studio studio, Path file) {
        this(studio, file, "");
    }

    /** Says over a window what the problem is, if there is one. */
    void tellProblem(Component window) {
        if (!problem.isEmpty()) {
            Messages.error(window, problem);
        }
    }
}
