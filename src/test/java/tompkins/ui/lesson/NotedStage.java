package tompkins.ui.lesson;

import java.util.ArrayList;
import java.util.List;
import tompkins.measure.LessonResult;
import tompkins.shutter.Shutter;

/** Notes what a lesson does with its picture. */
public final class NotedStage implements LessonStage {

    final List<Boolean> outlines = new ArrayList<>();
    final List<Class<?>> compared = new ArrayList<>();
    int flights;

    @Override
    public void mark(List<LessonResult> results) {
        // the window draws them
    }

    @Override
    public void showOutlines(boolean shown) {
        outlines.add(shown);
    }

    @Override
    public void compare(Class<? extends Shutter> shutter) {
        compared.add(shutter);
    }

    @Override
    public void fly() {
        flights++;
    }
}
