package tompkins.app;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import tompkins.animation.PictureState;
import tompkins.image.AsciiText;
import tompkins.io.JsonLayout;
import tompkins.render.RenderReport;
import tompkins.study.Measurement;
import tompkins.study.StudyKind;

/**
 * The error stream for programs that watch this one: each line is an object of JSON, in ASCII, that names its event.
 * The share of the work that is done comes at most once a second.
 */
final class JsonLines extends PrintWriter implements ProgressReport {

    private static final long INTERVAL_NANOS = 1_000_000_000;

    private static final Pattern NAMED = Pattern.compile("(warning|note): (.*)", Pattern.DOTALL);

    private long last = System.nanoTime();
    private int piece;
    private int pieces = 1;

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
    private void tell(String event, Map<String, Object> members) {
        Map<String, Object> all = new LinkedHashMap<>();
        all.put("event", event);
        all.putAll(members);
        super.println(AsciiText.escape(JsonLayout.line(all)));
    }

    @Override
    public synchronized void piece(int number, int count) {
        piece = number;
        pieces = count;
    }

    @Override
    public synchronized void setProgress(double share) {
        long now = System.nanoTime();
        if (now - last >= INTERVAL_NANOS) {
            last = now;
            // four digits are enough, and a whole number of them writes no others
            tell("progress", Map.of("done", Math.round(1e4 * (piece + share) / pieces) / 1e4));
        }
    }

    @Override
    public synchronized void picture(
            String kind, int number, int count, PictureState state, Path file, RenderReport report) {
        Map<String, Object> members = numbered(kind, number, count);
        members.put("state", state.name().toLowerCase(Locale.ROOT));
        if (file != null) {
            members.put("file", file.toString());
        }
        if (report != null) {
            members.put("seconds", report.time().toNanos() / 1e9);
            if (Double.isFinite(report.error())) {
                members.put("error", report.error());
            }
        }
        tell(kind, members);
    }

    @Override
    public synchronized void measured(StudyKind kind, Measurement point, int done, int count) {
        Map<String, Object> members = numbered("trial", done - 1, count);
        members.put("study", kind.toString());
        members.put("problem", point.problem());
        members.put("method", point.method());
        members.put("setting", point.setting());
        tell("trial", members);
        setProgress((double) done / count);
    }

    private static Map<String, Object> numbered(String kind, int number, int count) {
        Map<String, Object> members = new LinkedHashMap<>();
        members.put(kind, number);
        members.put("of", count);
        return members;
    }
}
