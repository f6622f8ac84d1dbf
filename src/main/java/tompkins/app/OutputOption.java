package tompkins.app;

import java.io.File;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import tompkins.image.FileException;
import tompkins.image.OutputFolder;

/** What the option {@code -o} of the commands means besides a name. */
final class OutputOption {

    private static final String NAME = "--output";

    private OutputOption() {}

    /**
     * Whether the name was written as that of a folder, with a separator at its end, which a {@code Path} does not
     * keep.
     */
    static boolean namesFolder(CommandSpec command) {
        OptionSpec option = command.findOption(NAME);
        return option.originalStringValues().stream()
                .anyMatch(written -> written.endsWith("/") || written.endsWith(File.separator));
    }

    /**
     * Does work that writes into a folder. The folder is made if there is none, and removed again if nothing was
     * written. A folder that cannot be made is a mistake.
     */
    static <T> T inFolder(Path folder, Callable<T> work) throws Exception {
        OutputFolder output = folder(folder);
        try {
            return work.call();
        } finally {
            output.close();
        }
    }

    private static OutputFolder folder(Path folder) {
        try {
            return OutputFolder.at(folder);
        } catch (FileException wrongPlace) {
            throw new MistakeException(wrongPlace.getMessage());
        }
    }
}
