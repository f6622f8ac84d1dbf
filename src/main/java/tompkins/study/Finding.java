package tompkins.study;

import java.util.Locale;

/**
 * One thing that a study must show.
 *
 * @param criterion what is judged
 * @param demanded what it has to be, from theory or as a promise
 * @param found what was measured
 * @param holds whether it is as demanded; if not, something in the program is broken
 */
public record Finding(String criterion, String demanded, String found, boolean holds) {

    /** A finding whose figures make a {@link String#format(String, Object...)} pattern. */
    static Finding of(boolean holds, String criterion, String demanded, String pattern, Object... figures) {
        return new Finding(criterion, demanded, text(pattern, figures), holds);
    }

    /** A {@link String#format(String, Object...)} pattern with its figures, the same in all countries. */
    static String text(String pattern, Object... figures) {
        return String.format(Locale.ROOT, pattern, figures);
    }

    /** Everything in one line. */
    public String sentence() {
        return criterion + ": " + found + " (demanded: " + demanded + ")";
    }
}
