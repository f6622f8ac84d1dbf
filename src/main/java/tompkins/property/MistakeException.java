package tompkins.property;

import java.util.List;
import java.util.function.Supplier;
import java.util.stream.Collectors;

/**
 * What somebody wrote or asked for cannot be. The message has a line for each mistake: its place, what is wrong, the
 * value, and what is allowed.
 */
public final class MistakeException extends RuntimeException {

    private static final long serialVersionUID = 1;

    /** One mistake. */
    public MistakeException(String mistake) {
        this(List.of(mistake));
    }

    /** Mistakes, at least one. */
    public MistakeException(List<String> mistakes) {
        super(mistakes.stream().map(OneLine::of).collect(Collectors.joining("\n")));
    }

    /** Makes something from the value of an option; if it is refused, the mistake names the option. */
    public static <T> T inOption(String option, Supplier<T> maker) {
        try {
            return maker.get();
        } catch (InvalidPropertyException refused) {
            throw new MistakeException(option + " " + refused.problem());
        }
    }
}
