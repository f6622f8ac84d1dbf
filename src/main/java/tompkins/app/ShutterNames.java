package tompkins.app;

import java.util.Iterator;
import java.util.Locale;
import java.util.stream.Stream;
import tompkins.shutter.Shutter;

/** The names of the shutter models on the command line, such as {@code detector-plane}. */
final class ShutterNames implements Iterable<String> {

    /** The name of a model. */
    static String of(Class<?> model) {
        return model.getSimpleName()
                .replaceFirst("Shutter$", "")
                .replaceAll("(?<=[a-z])(?=[A-Z])", "-")
                .toLowerCase(Locale.ROOT);
    }

    /** The names of all models. */
    @Override
    public Iterator<String> iterator() {
        return Stream.of(Shutter.class.getPermittedSubclasses())
                .map(ShutterNames::of)
                .iterator();
    }
}
