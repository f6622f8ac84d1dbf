package tompkins.study;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;

/** What follows from the figures of a study: sentences, and whether they are as theory and the program promise. */
public final class Conclusion {

    private static final Pattern BAR = Pattern.compile(" \\| ");

    /**
     * One thing that a study must show.
     *
     * @param criterion what is judged
     * @param demanded what it has to be, from theory or as a promise
     * @param found what was measured
     * @param holds whether it is as demanded; if not, something in the program is broken
     */
    public record Finding(String criterion, String demanded, String found, boolean holds) {

        /** Everything in one line. */
        public String sentence() {
            return criterion + ": " + found + " (demanded: " + demanded + ")";
        }
    }

    private final StringBuilder sentences = new StringBuilder();
    private final List<Finding> findings = new ArrayList<>();

    /**
     * What a study concludes.
     *
     * @param all the measurements of all its trials
     */
    public static Conclusion of(Study study, List<StudyPoint> all) {
        Conclusion conclusion = new Conclusion();
        study.conclude(all, conclusion);
        return conclusion;
    }

    /** Lets the next sentences begin a paragraph of their own. */
    void beginParagraph() {
        if (!sentences.isEmpty()) {
            sentences.append("\n\n");
        }
    }

    /** Adds sentences with their figures. */
    void say(String key, Object... figures) {
        sentences.append(StudyText.of(key, figures));
    }

    /** Adds a finding; its text with all figures has a bar between criterion, demand and what was found. */
    void demand(boolean holds, String key, Object... figures) {
        String[] parts = BAR.split(StudyText.of(key, figures));
        findings.add(new Finding(parts[0], parts[1], parts[2], holds));
    }

    /** What the charts show and what follows from it, in a few sentences of Markdown. */
    public String answer() {
        return sentences.toString();
    }

    /** What was demanded and what was found. */
    public List<Finding> findings() {
        return findings;
    }
}
