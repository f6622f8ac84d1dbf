package tompkins.app;

/** The user asked for something that cannot be; the message says what, and what is allowed. */
final class MistakeException extends RuntimeException {

    private static final long serialVersionUID = 1;

    MistakeException(String message) {
        super(message);
    }
}
