package tompkins.io;

import java.util.List;
import java.util.stream.Collectors;

/** A scene file that cannot be used. The message has one line for each mistake and is meant for the user. */
public final class SceneFileException extends RuntimeException {

    private static final long serialVersionUID = 1;

    private final transient List<Problem> problems;

    /**
     * Reports mistakes.
     *
     * @param problems at least one, in the order of the file
     */
    public SceneFileException(List<Problem> problems) {
        super(problems.stream().map(Problem::toString).collect(Collectors.joining("\n")));
        this.problems = List.copyOf(problems);
    }

    /** The mistakes, in the order of the file. */
    public List<Problem> problems() {
        return problems;
    }
}
