package tompkins.render;

/**
 * A picture could not be taken because of an error in the program or because memory ran out. Names the sample, if any.
 */
public final class RenderFailedException extends RuntimeException {

    private static final long serialVersionUID = 1;

    RenderFailedException(int column, int row, int sample, Throwable cause) {
        super("pixel " + column + "," + row + ", sample " + sample + ": " + cause, cause);
    }

    RenderFailedException(Throwable cause) {
        super(cause.toString(), cause);
    }
}
