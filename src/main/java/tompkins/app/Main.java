package tompkins.app;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.nio.charset.Charset;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import picocli.CommandLine;
import tompkins.property.NumberText;

/** Starts the program: a command line with its sub-commands, or the window. */
public final class Main {

    private Main() {}

    /**
     * Runs the program and ends the Java machine with the exit code: 0, 1 (a failure such as a full disk), or 2 (a
     * mistake in the arguments or in a scene).
     */
    public static void main(String[] arguments) {
        WatchedStream out = new WatchedStream(new FileOutputStream(FileDescriptor.out));
        PrintWriter err = printer(System.err);
        int code = run(printer(out), err, arguments);
        if (out.failure() != null) {
            code = Failures.reportLostOutput(out.failure(), err, code);
        }
        if (code != Failures.WINDOW_IS_OPEN) {
            System.exit(code);
        }
    }

    /** Letters that the terminal cannot show become question marks. */
    private static PrintWriter printer(OutputStream stream) {
        return new PrintWriter(stream, true, Charset.defaultCharset());
    }

    /** A file of some name; an empty one would mean the current folder. */
    private static Path file(String name) {
        if (name.isEmpty()) {
            throw new InvalidPathException(name, "empty");
        }
        return Path.of(name);
    }

    /** Runs the program and returns its exit code. */
    static int run(PrintWriter out, PrintWriter err, String... arguments) {
        CommandLine commandLine = TompkinsCommand.commandLine(arguments);
        commandLine.setOut(out);
        commandLine.setErr(err);
        // a name may begin with @
        commandLine.setExpandAtFiles(false);
        commandLine.setCaseInsensitiveEnumValuesAllowed(true);
        commandLine.registerConverter(Path.class, Main::file);
        commandLine.registerConverter(Double.class, NumberText::parse);
        commandLine.registerConverter(double.class, NumberText::parse);
        commandLine.setExecutionExceptionHandler(Failures::report);
        commandLine.setParameterExceptionHandler(Failures::reportUsage);
        try {
            return commandLine.execute(arguments);
        } catch (OutOfMemoryError tooMuch) {
            return Failures.reportMemory(err);
        }
    }
}
