package tompkins.app;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Objects;
import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.IVersionProvider;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;
import tompkins.io.SelfDescription;

/** A command, and what all of them have. */
@Command(mixinStandardHelpOptions = true, versionProvider = ProgramCommand.Version.class)
abstract class ProgramCommand implements Callable<Integer> {

    /** The version of the program, and of Java. */
    static final class Version implements IVersionProvider {

        @Override
        public String[] getVersion() {
            return new String[] {SelfDescription.program(), "Java " + System.getProperty("java.version")};
        }
    }

    @Spec
    private CommandSpec spec;

    /** The scene file with which it works at the moment, or null if there is no file: that of its argument SCENE. */
    Path scene() {
        return spec.positionalParameters().stream()
                .filter(argument -> argument.paramLabel().equals("SCENE"))
                .map(argument -> (Path) argument.getValue())
                .filter(Objects::nonNull)
                .findFirst()
                .orElse(null);
    }

    /** How it was called. */
    final CommandLine commandLine() {
        return spec.commandLine();
    }

    /** Where its results are printed. */
    final PrintWriter out() {
        return commandLine().getOut();
    }

    /** Where everything else is printed. */
    final PrintWriter err() {
        return commandLine().getErr();
    }
}
