package tompkins.ui.exchange;

import java.nio.file.Path;
import java.util.Optional;
import tompkins.animation.Animation;
import tompkins.studio.Studio;

/**
 * Writes command lines that repeat what the window does. They are empty if options cannot express what has changed; the
 * scene has to be saved first.
 */
public interface CommandLineWriter {

    /**
     * The command line that takes the same photograph as the window shows.
     *
     * @param studio what the window shows
     * @param opened the studio as it was read from the file or last saved
     * @param file where it was read from, or null
     */
    Optional<String> photograph(Studio studio, Studio opened, Path file);

    /**
     * The command line that saves an animation of what the window shows; the file has the usual name.
     *
     * @param captioned whether its pictures have captions
     */
    Optional<String> animation(Studio studio, Animation animation, boolean captioned, Studio opened, Path file);
}
