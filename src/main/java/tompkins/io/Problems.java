package tompkins.io;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import tompkins.property.OneLine;

/** Collects the mistakes of one file. */
final class Problems {

    /** After so many mistakes the rest of the file is not looked at. */
    static final int MOST = 100;

    private static final int LONGEST_VALUE = 60;
    private static final int LONGEST_PATH = 100;

    private final String file;
    private final List<Problem> found = new ArrayList<>();

    Problems(String file) {
        this.file = OneLine.of(file);
    }

    /** Notes a mistake in a value. */
    void add(JsonValue value, String path, String message) {
        add(value.line(), value.column(), path, message);
    }

    /**
     * Notes a mistake at a place.
     *
     * @throws SceneFileException if there are too many
     */
    void add(int line, int column, String path, String message) {
        found.add(new Problem(file, line, column, OneLine.shortened(path, LONGEST_PATH), OneLine.of(message)));
        if (found.size() == MOST) {
            sort();
            found.add(new Problem(file, line, column, "", "after " + MOST + " mistakes the rest is not looked at"));
            throw new SceneFileException(found);
        }
    }

    /** The exception for a mistake of the whole file. */
    SceneFileException wholeFile(String message) {
        add(0, 0, "", message);
        return new SceneFileException(found);
    }

    /** The exception for all mistakes that were found. */
    SceneFileException exception() {
        sort();
        return new SceneFileException(found);
    }

    private void sort() {
        found.sort(Comparator.comparingInt(Problem::line).thenComparingInt(Problem::column));
    }

    /** Whether there is no mistake. */
    boolean isEmpty() {
        return found.isEmpty();
    }

    /** A text of the user, for a message: in quotes and shortened if it is long. */
    static String quoted(String text) {
        return '"' + shortened(text) + '"';
    }

    /** A text on one line, shortened if it is long. */
    static String shortened(String text) {
        return OneLine.shortened(text, LONGEST_VALUE);
    }
}
