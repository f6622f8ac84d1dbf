package tompkins.app;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.nio.charset.Charset;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.function.BooleanSupplier;
import picocli.CommandLine;
import tompkins.property.NumberText;
import tompkins.ui.Displays;
import tompkins.ui.TompkinsWindow;

/** Starts the program: a command line with its sub-commands, or the window. */
public final class Main {

    private Main() {}

    /**
     * Runs the program and ends the Java machine with the exit code: 0, 1 (a failure such as a full disk), or 2 (a
     * mistake in the arguments or in a scene).
     */
    public static void main(String[] arguments) {
        if (TompkinsCommand.opensWindow(arguments) && Displays.usable()) {
            TompkinsWindow.prepare();
            if (arguments.length == 0 && opensFirstScene()) {
                return;
            }
        }
        WatchedStream out = new WatchedStream(new FileOutputStream(FileDescriptor.out));
        PrintWriter err = printer(System.err);
        int code = run(printer(out), err, Displays::usable, arguments);
        if (out.failure() != null) {
            code = Failures.reportLostOutput(out.failure(), err, code);
        }
        if (code != Failures.WINDOW_IS_OPEN) {
            System.exit(code);
        }
    }

    /**
     * Opens the window, if it can, without reading the arguments if there are none: this saves a tenth of a second of
     * the start.
     */
    private static boolean opensFirstScene() {
        try {
            TompkinsCommand.openWindow("");
            return true;
        } catch (IOException incomplete) {
            // the command line reports it
            return false;
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

    /**
     * Runs the program and returns its exit code.
     *
     * @param display whether a window can be opened; asked only if one is wanted, because the answer takes time
     */
    static int run(PrintWriter out, PrintWriter err, BooleanSupplier display, String... arguments) {
        CommandLine commandLine = TompkinsCommand.commandLine(display, arguments);
        commandLine.setOut(new TerminalPrinter(out));
        commandLine.setErr(new TerminalPrinter(err));
        // a name may begin with @
        commandLine.setExpandAtFiles(false);
        commandLine.setCaseInsensitiveEnumValuesAllowed(true);
        commandLine.registerConverter(Path.class, Main::file);
        commandLine.registerConverter(Double.class, NumberText::parse);
        commandLine.registerConverter(double.class, NumberText::parse);
        commandLine.setExecutionExceptionHandler(Failures::report);
        commandLine.setParameterExceptionHandler((exception, words) -> Failures.reportUsage(exception, words, display));
        try {
            return commandLine.execute(arguments);
        } catch (OutOfMemoryError tooMuch) {
            return Failures.reportMemory(commandLine);
        }
    }
}
