package tompkins.ui;

import java.util.List;
import tompkins.measure.LessonResult;
import tompkins.measure.OverlayKind;
import tompkins.shutter.Shutter;
import tompkins.ui.lesson.LessonStage;
import tompkins.ui.measure.MeasureMarks;

/** The photograph of a window as a lesson uses it. */
record LessonPicture(TompkinsWindow window, MeasureMarks marks) implements LessonStage {

    @Override
    public void mark(List<LessonResult> results) {
        marks.show(results);
        window.view().canvas().repaint();
    }

    @Override
    public void showOutlines(boolean shown) {
        // the overlays come later than the first lesson
        if (window.overlays != null && window.overlays.isShown(OverlayKind.MEASURED) != shown) {
            window.overlays.setShown(OverlayKind.MEASURED, shown);
        }
    }

    @Override
    public void compare(Class<? extends Shutter> shutter) {
        window.side.compare.compareShutter(shutter);
    }

    @Override
    public void fly() {
        window.motion.replayRide();
    }
}
