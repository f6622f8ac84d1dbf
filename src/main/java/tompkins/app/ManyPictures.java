package tompkins.app;

import java.util.List;
import picocli.CommandLine.Option;

/** Options of commands that take many pictures, so that several processes can share the work. */
final class ManyPictures {

    @Option(names = "--part", paramLabel = "I/N", description = "take each N-th picture from I on, counted from 0")
    private WorkPart part;

    @Option(
            names = "--skip-existing",
            description = "leave pictures that are there, if they hold the same scene and settings")
    private boolean skips;

    @Option(names = "--force", description = "replace files that are already there")
    private boolean force;

    /** Those of all pictures that are to be taken. */
    <T> List<T> own(List<T> all) {
        return part == null ? all : part.of(all);
    }

    /** Whether a part of them was asked for. */
    boolean hasPart() {
        return part != null;
    }

    /** Whether pictures are left that are there. */
    boolean skips() {
        return skips;
    }

    /** Whether files are replaced that are there. */
    boolean force() {
        return force;
    }
}
