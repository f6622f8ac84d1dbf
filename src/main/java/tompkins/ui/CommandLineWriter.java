package tompkins.ui;

import java.nio.file.Path;
import java.util.Optional;
import tompkins.studio.Studio;

/** Knows the command line that takes the same photograph as the window shows. */
@FunctionalInterface
public interface CommandLineWriter {

    /**
     * The command line; empty if none can say what has changed, so that the scene has to be saved first.
     *
     * @param studio what the window shows
     * @param opened the studio as it was read from the file or last saved
     * @param file where it was read from, or null
     */
    Optional<String> of(Studio studio, Studio opened, Path file);
}
