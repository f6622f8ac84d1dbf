package tompkins.app;

import java.io.PrintWriter;
import tompkins.property.OneLine;

/**
 * Prints lines for a terminal: names of files and texts of scenes may hold characters that it would obey. A line stays
 * one line, whatever it holds. What is printed without the end of its line is left alone, so that the program can use
 * such characters itself.
 */
final class TerminalPrinter extends PrintWriter {

    TerminalPrinter(PrintWriter terminal) {
        super(terminal, true);
    }

    @Override
    public void println(Object line) {
        println(String.valueOf(line));
    }

    @Override
    public void println(String line) {
        super.println(line == null ? null : OneLine.of(line));
    }
}
