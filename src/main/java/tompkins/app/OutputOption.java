package tompkins.app;

import java.io.BufferedOutputStream;
import java.io.File;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Model.OptionSpec;
import tompkins.file.FileException;
import tompkins.file.OutputFolder;
import tompkins.file.PendingFile;

/** What the option {@code -o} of the commands means besides a name. */
final class OutputOption {

    private static final String NAME = "--output";

    private OutputOption() {}

    /**
     * Whether the name was written as that of a folder, with a separator at its end, which a {@code Path} does not
     * keep.
     */
    static boolean namesFolder(CommandLine command) {
        OptionSpec option = command.getCommandSpec().findOption(NAME);
        return option.originalStringValues().stream()
                .anyMatch(written -> written.endsWith("/") || written.endsWith(File.separator));
    }

    /**
     * Does work that writes into a folder. The folder is made if there is none, and removed again if nothing was
     * written. A folder that cannot be made is a mistake.
     */
    static <T> T inFolder(Path folder, Callable<T> work) throws Exception {
        OutputFolder output = NamedFile.used(() -> OutputFolder.at(folder));
        try {
            return work.call();
        } finally {
            output.close();
        }
    }

    /** Writes bytes to the standard output, past the letters that are printed there. */
    static void toPipe(PendingFile.Content content) throws IOException {
        try {
            OutputStream out = new BufferedOutputStream(new FileOutputStream(FileDescriptor.out));
            content.writeTo(out);
            out.flush();
        } catch (IOException lost) {
            throw FileException.cannotWrite("standard output", lost);
        }
    }
}
