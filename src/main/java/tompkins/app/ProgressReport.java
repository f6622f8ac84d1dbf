package tompkins.app;

import java.io.PrintWriter;
import java.nio.file.Path;
import tompkins.animation.PictureState;
import tompkins.render.Progress;
import tompkins.render.RenderJob;
import tompkins.render.RenderListener;
import tompkins.render.RenderReport;
import tompkins.study.Measurement;
import tompkins.study.StudyKind;

/** Says how far a command is: to people on a terminal, or to programs. */
interface ProgressReport extends RenderListener, Progress {

    /** What is reported on an error stream. */
    static ProgressReport on(PrintWriter err) {
        return err instanceof JsonLines lines ? lines : new ProgressLine(err);
    }

    /** Whether somebody at a terminal looks on. */
    default boolean watched() {
        return false;
    }

    /** Says at once what is being done; the time that is left counts from here. */
    default void begin(String doing) {}

    /** What comes is one of several pieces of work, counted from 0. */
    default void piece(int number, int count) {}

    /**
     * A picture has come to a state.
     *
     * @param kind what it is: a frame of a film, or a picture of a scene
     * @param number its number, counted from 0
     * @param count how many there are
     * @param file its file; null if it has none of its own
     * @param report how it was taken; null unless it is done
     */
    default void picture(String kind, int number, int count, PictureState state, Path file, RenderReport report) {}

    /** A measurement of a study is made, or was known; {@code done} of {@code count} are. */
    default void measured(StudyKind kind, Measurement point, int done, int count) {}

    /** Removes what a terminal shows. */
    default void clear() {}

    @Override
    default void tileDone(RenderJob job) {
        setProgress(job.progress());
    }

    @Override
    default boolean isCancelled() {
        return false;
    }
}
