package tompkins.app;

import java.io.PrintWriter;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import tompkins.image.AsciiText;
import tompkins.io.JsonLayout;

/**
 * The error stream for programs that watch this one: each line is an object of JSON, in ASCII, that names its event.
 */
final class JsonLines extends PrintWriter {

    private static final Pattern NAMED = Pattern.compile("(warning|note): (.*)", Pattern.DOTALL);

    JsonLines(PrintWriter stream) {
        super(stream, true);
    }

    /** A line for people: a warning or note if it begins with that word, or else an error. */
    @Override
    public void println(String line) {
        Matcher named = NAMED.matcher(line);
        boolean isNamed = named.matches();
        tell(isNamed ? named.group(1) : "error", Map.of("message", isNamed ? named.group(2) : line));
    }

    @Override
    public void println(Object line) {
        println(String.valueOf(line));
    }

    /** Tells an event with what is known of it: texts and numbers by their keys. */
    void tell(String event, Map<String, Object> members) {
        Map<String, Object> all = new LinkedHashMap<>();
        all.put("event", event);
        all.putAll(members);
        super.println(AsciiText.escape(JsonLayout.line(all)));
    }
}
