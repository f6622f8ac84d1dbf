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
 * @param besideRest whether the photograph is shown beside that of a camera at rest, both with their speed
 */
public record FirstScene(Studio studio, Path file, String problem, boolean besideRest) {

    /** The scene that was asked for, alone. */
    public FirstScene(Studio studio, Path file) {
        this(studio, file, "", false);
    }

    /**
     * The scene of the program, if no other was asked for: it shows at once what motion does.
     *
     * @param problem why it is not the scene that was asked for; empty if there was none
     */
    public static FirstScene ofProgram(Studio studio, String problem) {
        return new FirstScene(studio, null, problem, true);
    }

    /** Says over a window what the problem is, if there is one. */
    void tellProblem(Component window) {
        if (!problem.isEmpty()) {
            Messages.error(window, problem);
        }
    }
}
