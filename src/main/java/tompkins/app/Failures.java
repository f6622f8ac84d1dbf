package tompkins.app;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.nio.file.FileSystemException;
import picocli.CommandLine;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import tompkins.image.FileFailure;
import tompkins.io.SceneFileException;
import tompkins.render.RenderFailedException;

/** What the program says when it cannot do what it was asked, and its exit codes. */
final class Failures {

    /** Something outside the user's words went wrong: a disk, the memory, the program itself. */
    static final int FAILURE = 1;

    /** The arguments or the scene are wrong; so is a place for a picture where nothing can be saved. */
    static final int MISTAKE = 2;

    /** Not an end at all: the window goes on. */
    static final int WINDOW_IS_OPEN = -1;

    private Failures() {}

    /** Reports what a command threw; only errors in the program itself show where they happened. */
    static int report(Exception exception, CommandLine commandLine, ParseResult arguments) throws Exception {
        PrintWriter err = commandLine.getErr();
        if (exception instanceof SceneFileException || exception instanceof MistakeException) {
            err.println(exception.getMessage());
            return MISTAKE;
        }
        if (exception instanceof FileSystemException failure) {
            err.println(failure.getFile() + ": cannot be read or written: " + FileFailure.reason(failure));
            return FAILURE;
        }
        if (exception instanceof IOException || exception instanceof UncheckedIOException) {
            err.println(exception.getMessage());
            return FAILURE;
        }
        if (exception instanceof RenderFailedException failed && failed.getCause() instanceof OutOfMemoryError) {
            return reportMemory(err);
        }
        throw exception;
    }

    /** Reports that what was asked is more than the memory holds. */
    static int reportMemory(PrintWriter err) {
        long most = Runtime.getRuntime().maxMemory();
        err.println("not enough memory: Java may use " + (most >> 20) + " MB; start java with a larger -Xmx");
        return FAILURE;
    }

    /** Reports that words of the program were lost; the exit code with that. */
    static int reportLostOutput(IOException failure, PrintWriter err, int code) {
        err.println("the output cannot be written: " + failure.getMessage());
        return code == 0 ? FAILURE : code;
    }

    /** Reports a mistake in the arguments, with the name that was perhaps meant. */
    static int reportUsage(ParameterException exception, String[] arguments) {
        CommandLine commandLine = exception.getCommandLine();
        PrintWriter err = commandLine.getErr();
        err.println(Ansi.AUTO.string("@|bold " + commandLine.getCommandSpec().qualifiedName() + ":|@ ")
                + ArgumentMistake.message(exception, arguments));
        err.println("Try '" + commandLine.getCommandSpec().qualifiedName() + " --help'.");
        return MISTAKE;
    }
}
