package tompkins.app;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.nio.charset.Charset;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import picocli.CommandLine;
import tompkins.property.Descriptions;
import tompkins.property.MistakeException;
import tompkins.sceneobject.SceneObject;
import tompkins.shutter.Shutter;
import tompkins.surface.Surface;
import tompkins.ui.Displays;
import tompkins.ui.TompkinsWindow;

/** Starts the program: a command line with its sub-commands, or the window. */
public final class Main {

    private Main() {}

    /**
     * Runs the program and ends the Java machine with the exit code: 0, 1 (a failure such as a full disk), 2 (a mistake
     * in the arguments or in a scene), or 3 (frames of a film are missing).
     */
    public static void main(String[] arguments) {
        giveHome();
        if (TompkinsCommand.isNamedBy(arguments)) {
            // no command shows anything, and a display that is set but dead would be an error
            System.setProperty("java.awt.headless", "true");
        } else if (TompkinsCommand.opensWindow(arguments) && Displays.usable()) {
            TompkinsWindow.prepare();
        }
        readAddedTypes();
        // help keeps to the width of the terminal
        System.setProperty("picocli.usage.width", "AUTO");
        WatchedStream out = new WatchedStream(new FileOutputStream(FileDescriptor.out));
        PrintWriter err = printer(System.err);
        int code = run(printer(out), err, Displays::usable, arguments);
        if (out.failure() != null) {
            err.println("the output cannot be written: " + out.failure().getMessage());
            code = code == 0 ? Failures.FAILURE : code;
        }
        if (code != Failures.WINDOW_IS_OPEN) {
            System.exit(code);
        }
    }

    /**
     * A user without a name has no home: Java says {@code ?}, and would keep what it knows of fonts in a folder of that
     * name. Nothing can be kept at the place that is named instead.
     */
    private static void giveHome() {
        if (System.getProperty("user.home", "?").equals("?")) {
            String home = System.getenv("HOME");
            System.setProperty("user.home", home != null && home.startsWith("/") ? home : "/dev/null");
        }
    }

    /** Reads the types that other jars add, before any argument: what is wrong with one ends the program. */
    private static void readAddedTypes() {
        try {
            Stream.of(Surface.class, SceneObject.class, Shutter.class).forEach(Descriptions::members);
        } catch (MistakeException wrong) {
            System.err.println(wrong.getMessage());
            System.exit(Failures.MISTAKE);
        }
    }

    /** Letters that the terminal cannot show become question marks. */
    private static PrintWriter printer(OutputStream stream) {
        return new PrintWriter(stream, true, Charset.defaultCharset());
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
        OptionValues.addTo(commandLine);
        commandLine.setExecutionExceptionHandler(Failures::report);
        commandLine.setParameterExceptionHandler(Failures::reportUsage);
        try {
            return commandLine.execute(arguments);
        } catch (OutOfMemoryError tooMuch) {
            return Failures.reportMemory(commandLine);
        }
    }
}
