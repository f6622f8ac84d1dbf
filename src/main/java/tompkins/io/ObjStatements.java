package tompkins.io;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import tompkins.math.Precise;

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

    private static final String BYTE_ORDER_MARK = "\uFEFF";

    private static final char NEXT_LINE = '\u0085';

    /** Larger whole numbers become this one; ten times as much still has a place in 64 bits. */
    private static final long LARGEST = 1L << 59;

    private final String file;

    private int linesRead;
    private int firstLine;

    /** Where the next line begins. */
    private int next;

    /** The file, or a statement of several lines, and from where to where the statement is in it. */
    private String text = "";

    private int start;
    private int end;

    private int wordStart;
    private int wordEnd;

    /** What of the word was read as numbers ends here. */
    private int at;

    /**
     * The statements of a file.
     *
     * @throws ObjMistake if its text is in another encoding
     */
    ObjStatements(byte[] file) {
        this.file = new String(file, StandardCharsets.UTF_8);
        Optional<String> wrong = SceneText.wrongEncoding(file);
        if (wrong.isPresent()) {
            throw new ObjMistake(1, wrong.get());
        }
        next = this.file.startsWith(BYTE_ORDER_MARK) ? 1 : 0;
    }

    /** Goes to the next statement, before its first word; false after the last one. */
    boolean next() {
        firstLine = linesRead + 1;
        if (!nextLine()) {
            return false;
        }
        text = file;
        if (isContinued()) {
            text = continued();
            start = 0;
            end = text.length();
        }
        wordEnd = start;
        return true;
    }

    private String continued() {
        StringBuilder joined = new StringBuilder();
        boolean more = true;
        while (more) {
            more = isContinued();
            joined.append(file, start, more ? end - 1 : end).append(' ');
            more = more && nextLine();
        }
        return joined.toString();
    }

    private boolean isContinued() {
        return end > start && file.charAt(end - 1) == '\\';
    }

    /** Goes to the next line, without its comment and the blanks at its end; false after the last one. */
    private boolean nextLine() {
        if (next >= file.length()) {
            return false;
        }
        linesRead++;
        start = next;
        end = start;
        boolean comment = false;
        for (; next < file.length() && !isLineEnd(file.charAt(next)); next++) {
            comment |= file.charAt(next) == '#';
            if (!comment && !isBlank(file.charAt(next))) {
                end = next + 1;
            }
        }
        next += file.startsWith("\r\n", next) ? 2 : 1;
        return true;
    }

    private static boolean isLineEnd(char letter) {
        return letter == '\n' || letter == '\r';
    }

    /** Blanks of all kinds, including those of typesetters; other control characters part no words. */
    private static boolean isBlank(char letter) {
        return letter == ' '
                || letter >= '\t' && letter <= '\r'
                || letter == NEXT_LINE
                || Character.isSpaceChar(letter);
    }

    /** Goes to the next word of the statement; false after the last one. */
    boolean nextWord() {
        wordStart = wordEnd;
        while (wordStart < end && isBlank(text.charAt(wordStart))) {
            wordStart++;
        }
        wordEnd = wordStart;
        while (wordEnd < end && !isBlank(text.charAt(wordEnd))) {
            wordEnd++;
        }
        at = wordStart;
        return wordEnd > wordStart;
    }

    /** The word. */
    String word() {
        return text.substring(wordStart, wordEnd);
    }

    /** What follows the word, without the blanks around it, and without quotation marks around all of it. */
    String rest() {
        int from = wordEnd;
        int to = end;
        while (from < to && isBlank(text.charAt(from))) {
            from++;
        }
        while (from < to && isBlank(text.charAt(to - 1))) {
            to--;
        }
        return unquoted(text.substring(from, to));
    }

    /** A name, which some programs write in quotation marks. */
    static String unquoted(String name) {
        boolean isQuoted = name.length() > 2 && name.startsWith("\"") && name.indexOf('"', 1) == name.length() - 1;
        return isQuoted ? name.substring(1, name.length() - 1) : name;
    }

    /** The words of a {@linkplain #rest rest}. */
    static List<String> words(String rest) {
        return List.of(rest.split("[\\s\\u0085\\p{Z}]+"));
    }

    /** Whether the word is a given one, in small or capital letters. */
    boolean wordIs(String other) {
        return wordEnd - wordStart == other.length() && text.regionMatches(true, wordStart, other, 0, other.length());
    }

    /**
     * The number that the word is, rounded as {@link Double#parseDouble} does; NaN if it is none, or written in a way
     * that takes longer.
     */
    double decimal() {
        boolean negative = isNext('-');
        int first = at;
        long digits = digits(0);
        long power = 0;
        if (isNext('.')) {
            long point = at;
            digits = digits(digits);
            power = point - at;
        }
        if (isNext('e') || isNext('E')) {
            power += wholeNumber();
        }
        if (!isWordRead() || at == first || !isDigit(text.charAt(first)) || !isDigit(text.charAt(at - 1))) {
            return Double.NaN;
        }
        double size = digits == LARGEST ? Double.NaN : Precise.decimal(digits, power);
        return negative ? -size : size;
    }

    /** The whole number that begins where the one before ended, with a sign or without; 0 if there is none. */
    long wholeNumber() {
        boolean negative = isNext('-');
        if (!negative) {
            isNext('+');
        }
        long size = digits(0);
        return negative ? -size : size;
    }

    /** Whether all of the word was read as numbers. */
    boolean isWordRead() {
        return at == wordEnd;
    }

    private long digits(long before) {
        long number = before;
        for (; at < wordEnd && isDigit(text.charAt(at)); at++) {
            number = Math.min(LARGEST, 10 * number + text.charAt(at) - '0');
        }
        return number;
    }

    private static boolean isDigit(char letter) {
        return letter >= '0' && letter <= '9';
    }

    /** Goes past a letter of the word if it is next. */
    boolean isNext(char letter) {
        boolean isNext = at < wordEnd && text.charAt(at) == letter;
        at += isNext ? 1 : 0;
        return isNext;
    }

    /** The line where the statement begins, counted from 1. */
    int firstLine() {
        return firstLine;
    }

    /** A mistake in the statement. */
    ObjMistake mistake(String message) {
        return new ObjMistake(firstLine, message);
    }

    /** All of the statement. */
    String statement() {
        return text.substring(start, end).strip();
    }

    /** The statement cannot be understood at all. */
    ObjMistake unclear() {
        return mistake(Problems.quoted(statement())
                + " cannot be understood; a vertex is written like \"v 0 1.5 -2\","
                + " a face like \"f 1 2 3\" with vertices counted from 1");
    }
}
