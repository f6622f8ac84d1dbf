package tompkins.io;

/**
 * One mistake in a file.
 *
 * @param file the file, as the user named it
 * @param line from 1; 0 if the mistake concerns the whole file
 * @param column in characters, from 1; 0 if the mistake concerns the whole file
 * @param path the keys that lead to the place, such as {@code scene[2].radius}; empty for the whole scene
 * @param message what is wrong, the value, and what is allowed
 */
public record Problem(String file, int line, int column, String path, String message) {

    /** The mistake in one line: {@code file:line:column: path: message}. */
    @Override
    public String toString() {
        String place = line == 0 ? file : file + ":" + line + ":" + column;
        return place + ": " + (path.isEmpty() ? message : path + ": " + message);
    }
}
