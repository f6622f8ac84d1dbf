package tompkins.ui;

import java.nio.file.Path;
import java.util.Optional;
import tompkins.animation.Animation;
import tompkins.studio.Studio;
import tompkins.ui.exchange.CommandLineWriter;

/** Command lines that say no more than what is done with which file; which words there are is tested elsewhere. */
final class NamedCommands implements CommandLineWriter {

    @Override
    public Optional<String> photograph(Studio studio, Studio opened, Path file) {
        return Optional.of("tompkins render " + file);
    }

    @Override
    public Optional<String> animation(Studio studio, Animation animation, boolean captioned, Studio opened, Path file) {
        return Optional.of("tompkins animate " + file + " " + animation.number().path() + " to " + animation.to());
    }
}
