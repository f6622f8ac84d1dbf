package tompkins.study;

import java.util.List;

/** How one question about speed and accuracy is answered. */
public interface Study {

    /** Everything that changes the figures; figures measured with other settings do not count. */
    String settings();

    /** What is to be measured, in this order. */
    List<Trial> trials();

    /** What is drawn. */
    List<Chart> charts();

    /**
     * Says what the figures show.
     *
     * @param all the measurements of all trials
     */
    void conclude(List<StudyPoint> all, Conclusion conclusion);
}
