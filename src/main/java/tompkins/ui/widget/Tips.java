package tompkins.ui.widget;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/** Tooltips that wrap their lines. */
public final class Tips {

    private static final int LONGEST_LINE = 60;

    private Tips() {}

    /** A tooltip in lines that are not too long, broken between words, and within words that are longer than a line. */
    public static String wrapped(String text) {
        return text.lines().flatMap(line -> lines(line).stream()).collect(Collectors.joining("\n"));
    }

    private static List<String> lines(String text) {
        List<String> lines = new ArrayList<>();
        String rest = text;
        while (rest.length() > LONGEST_LINE) {
            int space = rest.lastIndexOf(' ', LONGEST_LINE);
            int end = space > 0 ? space : LONGEST_LINE;
            lines.add(rest.substring(0, end));
            rest = rest.substring(end).stripLeading();
        }
        lines.add(rest);
        return lines;
    }
}
