package tompkins.io;

import java.io.IOException;

/** A mesh could not be read. The message is one line: the file, the place in it, what is wrong, and what is allowed. */
public final class MeshException extends IOException {

    private static final long serialVersionUID = 1;

    MeshException(String message) {
        super(message);
    }

    MeshException(String message, Throwable cause) {
        super(message, cause);
    }
}
