package tompkins.study;

import java.util.List;
import java.util.stream.Collectors;

/**
 * Several studies that answer one question together.
 *
 * @param parts the studies; no two of them have a problem of the same name
 */
record JointStudy(List<Study> parts) implements Study {

    @Override
    public String settings() {
        return parts.stream().map(Study::settings).collect(Collectors.joining("; "));
    }

    @Override
    public List<Trial> trials() {
        return parts.stream().flatMap(part -> part.trials().stream()).toList();
    }

    @Override
    public List<Chart> charts() {
        return parts.stream().flatMap(part -> part.charts().stream()).toList();
    }

    @Override
    public void conclude(List<StudyPoint> all, Conclusion conclusion) {
        for (Study part : parts) {
            conclusion.beginParagraph();
            part.conclude(all, conclusion);
        }
    }
}
