package tompkins.study;

/**
 * One thing that a study must show.
 *
 * @param criterion what is judged
 * @param demanded what it has to be, from theory or as a promise
 * @param found what was measured
 * @param holds whether it is as demanded; if not, something in the program is broken
 */
public record Finding(String criterion, String demanded, String found, boolean holds) {

    /** Everything in one line. */
    public String sentence() {
        return criterion + ": " + found + " (demanded: " + demanded + ")";
    }
}
