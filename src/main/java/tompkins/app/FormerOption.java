package tompkins.app;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import tompkins.property.Descriptions;
import tompkins.shutter.Shutter;

/** Options of earlier versions, which {@code --set} has replaced. */
final class FormerOption {

    private static final String SHUTTER = "--shutter";

    private static final Map<String, String> PATHS = Map.of(
            SHUTTER,
            "camera.shutter.type",
            "--sweep",
            "camera.rollingShutter.sweep",
            "--rolling",
            "camera.rollingShutter.direction",
            "--metering",
            "metering",
            "--view",
            "view",
            "--tone",
            "settings.toneCurve");

    private FormerOption() {}

    /** What to type instead of all former options among some words; empty if there are none. */
    static Optional<String> replacement(String... words) {
        List<Integer> indices = IntStream.range(0, words.length)
                .filter(i -> PATHS.containsKey(name(words[i])))
                .boxed()
                .toList();
        if (indices.isEmpty()) {
            return Optional.empty();
        }
        String former = indices.stream().map(i -> name(words[i])).collect(Collectors.joining(", "));
        return Optional.of(former + ": replaced by " + SetOption.NAME + "; write "
                + indices.stream().map(i -> setting(words, i)).collect(Collectors.joining(" ")));
    }

    private static String name(String word) {
        return word.replaceFirst("=.*", "");
    }

    private static String setting(String[] words, int index) {
        String name = name(words[index]);
        boolean isJoined = words[index].length() > name.length();
        String value = isJoined
                ? words[index].substring(name.length() + 1)
                : index + 1 < words.length ? words[index + 1] : "VALUE";
        return SetOption.NAME + " " + PATHS.get(name) + "=" + (name.equals(SHUTTER) ? shutter(value) : value);
    }

    /** The type of a shutter that had a name such as {@code detector-plane}; another name stays as it is. */
    private static String shutter(String name) {
        String plain = name.replaceAll("[-_ ]", "").toLowerCase(Locale.ROOT);
        return Arrays.stream(Shutter.class.getPermittedSubclasses())
                .map(Descriptions::name)
                .filter(type -> type.toLowerCase(Locale.ROOT).startsWith(plain))
                .findFirst()
                .orElse(name);
    }
}
