package tompkins.io;

/** A statement of an OBJ file that cannot be used. The message says why, without the place. */
final class ObjMistake extends RuntimeException {

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
