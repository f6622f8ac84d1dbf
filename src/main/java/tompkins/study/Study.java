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
     * What the charts show and what follows from it, in a few sentences of Markdown.
     *
     * @param all the measurements of all trials
     */
    String answer(List<Measurement> all);

    /**
     * Whether the measurements are as theory and the program's promises demand.
     *
     * @param all the measurements of all trials
     */
    List<Finding> findings(List<Measurement> all);
}
