package tompkins.ui;

import java.io.IOException;
import tompkins.studio.Studio;

/** A scene that the menu of examples offers. */
public interface Example {

    /** What the menu calls it. */
    String title();

    /** The heading under which the menu lists it. */
    String topic();

    /**
     * The scene. Called away from the event thread.
     *
     * @throws IOException with a message for the user, if it cannot be read
     */
    Studio load() throws IOException;
}
