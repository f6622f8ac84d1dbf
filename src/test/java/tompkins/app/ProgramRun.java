package tompkins.app;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;

/** One run of the program inside the test: exit code and what it printed. */
record ProgramRun(int code, String out, String err) {

    /** A scene file for tests that need one, whichever it is. */
    static final String FIG1B = "scenes/fig1b.json";

    /** A run as on a machine without a display. */
    static ProgramRun of(Object... arguments) {
        return of(() -> false, arguments);
    }

    /** A run with some words, and more behind them. */
    static ProgramRun of(List<?> words, Object... more) {
        return of(Stream.concat(words.stream(), Stream.of(more)).toArray());
    }

    /** A run that opens a window, if it is to and if there is a display for it. */
    static ProgramRun of(BooleanSupplier display, Object... arguments) {
        String[] words = new String[arguments.length];
        for (int i = 0; i < words.length; i++) {
            words[i] = arguments[i].toString();
        }
        StringWriter out = new StringWriter();
        StringWriter err = new StringWriter();
        int code = Main.run(new PrintWriter(out, true), new PrintWriter(err, true), display, words);
        return new ProgramRun(code, lines(out), lines(err));
    }

    /** What was printed, with the ends of lines of Linux on every system. */
    private static String lines(StringWriter printed) {
        return printed.toString().replace(System.lineSeparator(), "\n");
    }
}
