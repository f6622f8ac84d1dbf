package tompkins.io;

import java.io.BufferedReader;
import java.io.IOException;

/**
 * The statements of an OBJ file one after the other, each cut into its words. A comment ends its line. A backslash at
 * the end of a line continues the statement on the next line, and separates two words.
 */
final class ObjStatements {

    /** A statement that cannot be used. The message says why, without the place. */
    static final class ObjMistake extends RuntimeException {

        private static final long serialVersionUID = 1;

        private final int line;

        /** A mistake in the statement that begins in a line, counted from 1. */
        ObjMistake(int line, String message) {
            super(message);
            this.line = line;
        }

        int line() {
            return line;
        }
    }

    private static final char BYTE_ORDER_MARK = '\uFEFF';

    private static final char NEXT_LINE = '\u0085';

    private final BufferedReader lines;
    private int linesRead;
    private int firstLine;
    private String text = "";
    private int wordStart;
    private int wordEnd;

    ObjStatements(BufferedReader lines) {
        this.lines = lines;
    }

    /** Goes to the next statement, before its first word; false after the last one. */
    boolean next() throws IOException {
        firstLine = linesRead + 1;
        String line = line();
        if (line == null) {
            return false;
        }
        text = isContinued(line) ? continued(line) : line;
        wordEnd = 0;
        return true;
    }

    private String continued(String first) throws IOException {
        StringBuilder joined = new StringBuilder();
        String part = first;
        while (part != null && isContinued(part)) {
            joined.append(part, 0, part.length() - 1).append(' ');
            part = line();
        }
        return joined.append(part == null ? "" : part).toString();
    }

    private static boolean isContinued(String line) {
        return line.endsWith("\\");
    }

    /** The next line without its comment and the blanks at its end, or null after the last one. */
    private String line() throws IOException {
        String line = lines.readLine();
        if (line == null) {
            return null;
        }
        linesRead++;
        int start = linesRead == 1 && !line.isEmpty() && line.charAt(0) == BYTE_ORDER_MARK ? 1 : 0;
        int comment = line.indexOf('#');
        int end = comment < 0 ? line.length() : comment;
        while (end > start && isBlank(line.charAt(end - 1))) {
            end--;
        }
        return line.substring(start, end);
    }

    /** Blanks of all kinds, including those of typesetters; other control characters part no words. */
    private static boolean isBlank(char letter) {
        return letter == ' ' || letter >= '\t' && letter <= '\r' || letter >= NEXT_LINE && isFarBlank(letter);
    }

    private static boolean isFarBlank(char letter) {
        return letter == NEXT_LINE || Character.isSpaceChar(letter);
    }

    /** Goes to the next word of the statement; false after the last one. */
    boolean nextWord() {
        wordStart = wordEnd;
        while (wordStart < text.length() && isBlank(text.charAt(wordStart))) {
            wordStart++;
        }
        wordEnd = wordStart;
        while (wordEnd < text.length() && !isBlank(text.charAt(wordEnd))) {
            wordEnd++;
        }
        return wordEnd > wordStart;
    }

    /** The word. */
    String word() {
        return text.substring(wordStart, wordEnd);
    }

    /** What follows the word, without the blanks around it. */
    String rest() {
        return text.substring(wordEnd).strip();
    }

    /** Whether the word is a given one, in small or capital letters. */
    boolean wordIs(String other) {
        return wordEnd - wordStart == other.length() && text.regionMatches(true, wordStart, other, 0, other.length());
    }

    /** The line where the statement begins, counted from 1. */
    int firstLine() {
        return firstLine;
    }

    /** A mistake in the statement. */
    ObjMistake mistake(String message) {
        return new ObjMistake(firstLine, message);
    }

    /** The statement cannot be understood at all. */
    ObjMistake unclear() {
        return mistake(Problems.quoted(text.strip()) + " cannot be understood; a vertex is written like \"v 0 1.5 -2\","
                + " a face like \"f 1 2 3\" with vertices counted from 1");
    }
}
