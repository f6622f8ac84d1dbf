package tompkins.app;

import java.io.PrintWriter;
import java.util.regex.Pattern;

/**
 * Prints lines for a terminal, which obeys control characters instead of showing them: names of files and texts of
 * scenes may hold some. Each becomes a space, except new lines and tabs. What is printed without the end of its line is
 * left alone, so that the program can use such characters itself.
 */
final class TerminalPrinter extends PrintWriter {

    private static final Pattern CONTROLS = Pattern.compile("[\\p{Cc}&&[^\\n\\t]]+");

    TerminalPrinter(PrintWriter terminal) {
        super(terminal, true);
    }

    @Override
    public void println(Object line) {
        println(String.valueOf(line));
    }

    @Override
    public void println(String line) {
        super.println(line == null ? null : CONTROLS.matcher(line).replaceAll(" "));
    }
}
