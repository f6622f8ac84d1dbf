package tompkins;

import java.io.File;
import java.nio.file.Path;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The Java that runs the tests, for processes of their own. */
public final class RunningJava {

    /** Its program. */
    public static final String PROGRAM =
            Path.of(System.getProperty("java.home"), "bin", "java").toString();

    /** The classes of the program and of the tests, wherever a process is started. */
    public static final String CLASS_PATH = Stream.of(
                    System.getProperty("java.class.path").split(File.pathSeparator))
            .map(part -> Path.of(part).toAbsolutePath().toString())
            .collect(Collectors.joining(File.pathSeparator));

    private RunningJava() {}
}
