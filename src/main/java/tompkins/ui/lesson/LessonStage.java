package tompkins.ui.lesson;

import java.util.List;
import tompkins.measure.LessonResult;
import tompkins.shutter.Shutter;

/** What a lesson does with its picture. */
public interface LessonStage {

    /** Draws into the picture where something was measured; nothing if the list is empty. */
    void mark(List<LessonResult> results);

    /** Draws where things are at the time of the picture, or not. */
    void showOutlines(boolean shown);

    /** Shows the picture that another shutter takes beside the picture. */
    void compare(Class<? extends Shutter> shutter);

    /** Flies the ride of the scene from where the camera is. */
    void fly();
}
