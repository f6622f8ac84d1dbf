package tompkins.app;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import tompkins.animation.PictureState;
import tompkins.render.RenderReport;
import tompkins.study.Measurement;
import tompkins.study.StudyKind;

/** Tells programs how far a command is. The share of the work that is done comes at most once a second. */
final class ProgressEvents extends ProgressReport {

    private static final long INTERVAL_NANOS = 1_000_000_000;

    private final JsonLines lines;
    private long last = System.nanoTime();
    private int piece;
    private int pieces = 1;

    ProgressEvents(JsonLines lines) {
        this.lines = lines;
    }

    @Override
    synchronized void piece(int number, int count) {
        piece = number;
        pieces = count;
    }

    @Override
    public synchronized void setProgress(double share) {
        long now = System.nanoTime();
        if (now - last >= INTERVAL_NANOS) {
            last = now;
            // four digits are enough, and a whole number of them writes no others
            lines.tell("progress", Map.of("done", Math.round(1e4 * (piece + share) / pieces) / 1e4));
        }
    }

    @Override
    synchronized void picture(String kind, int number, int count, PictureState state, Path file, RenderReport report) {
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
        lines.tell(kind, members);
    }

    @Override
    synchronized void measured(StudyKind kind, Measurement point, int done, int count) {
        Map<String, Object> members = numbered("trial", done - 1, count);
        members.put("study", kind.toString());
        members.put("problem", point.problem());
        members.put("method", point.method());
        members.put("setting", point.setting());
        lines.tell("trial", members);
        setProgress((double) done / count);
    }

    private static Map<String, Object> numbered(String kind, int number, int count) {
        Map<String, Object> members = new LinkedHashMap<>();
        members.put(kind, number);
        members.put("of", count);
        return members;
    }
}
