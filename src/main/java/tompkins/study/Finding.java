package tompkins.study;

import java.util.Locale;

/**
 * One sentence about what a study shows.
 *
 * @param sentence with its figures
 * @param holds whether it is as it must be; if not, something in the program is broken
 */
public record Finding(String sentence, boolean holds) {

    /** A finding that must hold, its sentence a {@link String#format(String, Object...)} pattern. */
    static Finding check(boolean holds, String pattern, Object... values) {
        return new Finding(String.format(Locale.ROOT, pattern, values), holds);
    }

    /** A finding without a limit. */
    static Finding note(String pattern, Object... values) {
        return check(true, pattern, values);
    }
}
