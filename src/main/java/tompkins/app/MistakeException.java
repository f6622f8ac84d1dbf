package tompkins.app;

import java.util.function.Supplier;
import tompkins.property.InvalidPropertyException;
import tompkins.property.OneLine;

/** The user asked for something that cannot be; the message says what, and what is allowed. */
final class MistakeException extends RuntimeException {

    private static final long serialVersionUID = 1;

    /** Takes a complete message, and makes one line of it. */
    MistakeException(String message) {
        super(OneLine.of(message));
    }

    /** Makes something from the value of an option; if it is refused, the mistake names the option. */
    static <T> T inOption(String option, Supplier<T> maker) {
        return inOption(option, "", maker);
    }

    /** As {@link #inOption(String, Supplier)}; the message ends in a hint. */
    static <T> T inOption(String option, String hint, Supplier<T> maker) {
        try {
            return maker.get();
        } catch (InvalidPropertyException invalid) {
            throw new MistakeException(option + " " + invalid.problem() + hint);
        }
    }
}
