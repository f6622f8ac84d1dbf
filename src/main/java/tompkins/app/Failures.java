package tompkins.app;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;
import picocli.CommandLine;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.TypeConversionException;
import picocli.CommandLine.UnmatchedArgumentException;
import tompkins.file.FileFailure;
import tompkins.io.Assignments;
import tompkins.io.Spelling;
import tompkins.property.MistakeException;

/** What the program says when it cannot do what it was asked, and its exit codes. */
final class Failures {

    /** Something that the user did not write went wrong: a disk, the memory, the program itself. */
    static final int FAILURE = 1;

    /** The arguments or the scene are wrong; so is a place for a picture where nothing can be saved. */
    static final int MISTAKE = 2;

    /** Nothing is wrong, but frames of a film are still to be taken. */
    static final int INCOMPLETE = 3;

    /** The program does not end: its window is open. */
    static final int WINDOW_IS_OPEN = -1;

    private Failures() {}

    /** Reports what a command threw; only errors in the program itself show where they happened. */
    static int report(Exception exception, CommandLine commandLine, ParseResult arguments) throws Exception {
        PrintWriter err = commandLine.getErr();
        if (isOfMemory(exception)) {
            return reportMemory(commandLine);
        }
        if (exception instanceof MistakeException) {
            exception.getMessage().lines().forEach(err::println);
            return MISTAKE;
        }
        if (exception instanceof FileSystemException failure) {
            err.println(failure.getFile() + ": cannot be read or written: " + FileFailure.reason(failure));
            return FAILURE;
        }
        if (exception instanceof IOException || exception instanceof UncheckedIOException) {
            err.println(exception.getMessage());
            return FAILURE;
        }
        throw exception;
    }

    /** Whether memory ran out, in whatever exception that is wrapped. */
    private static boolean isOfMemory(Throwable failure) {
        return Stream.iterate(failure, Objects::nonNull, Throwable::getCause)
                .anyMatch(OutOfMemoryError.class::isInstance);
    }

    /** Reports that what was asked is more than the memory holds. */
    static int reportMemory(CommandLine commandLine) {
        ParseResult called = commandLine.getParseResult();
        while (called.hasSubcommand()) {
            called = called.subcommand();
        }
        Path scene = called.commandSpec().userObject() instanceof ProgramCommand command ? command.scene() : null;
        commandLine.getErr().println(memoryMessage(scene));
        return FAILURE;
    }

    /** The message if the memory is too small for a file, or null. */
    static String memoryMessage(Path file) {
        long most = Runtime.getRuntime().maxMemory();
        return (file == null ? "" : file + ": ") + "not enough memory: Java may use " + (most >> 20)
                + " MB; start java with a larger -Xmx";
    }

    /** Reports a mistake in the arguments, with the name that may have been meant. */
    static int reportUsage(ParameterException exception, String... arguments) {
        CommandLine commandLine = exception.getCommandLine();
        PrintWriter err = commandLine.getErr();
        String mistake = usageMistake(exception, arguments);
        err.print(Ansi.AUTO.string("@|bold " + commandLine.getCommandSpec().qualifiedName() + ":|@ "));
        err.println(mistake);
        err.println("Try '" + commandLine.getCommandSpec().qualifiedName() + " --help'.");
        return MISTAKE;
    }

    /** What is wrong with arguments: mostly in the words of the library that reads them. */
    private static String usageMistake(ParameterException mistake, String... arguments) {
        if (mistake instanceof UnmatchedArgumentException unmatched) {
            return unmatched(unmatched, mistake.getCommandLine().getCommandSpec(), arguments[0]);
        }
        if (mistake.getCause() instanceof MistakeException wrongName) {
            return wrongName.getMessage();
        }
        if (mistake.getCause() instanceof TypeConversionException refused) {
            ArgSpec argument = mistake.getArgSpec();
            String name = argument instanceof OptionSpec option ? option.longestName() : argument.paramLabel();
            if (argument.arity().max() == 0) {
                return name + " takes no value";
            }
            String refusal = refused.getMessage();
            return name
                    + (refusal.startsWith("must") ? " " : ": ")
                    + refusal
                    + (argument.arity().min() < argument.arity().max()
                            ? "; without a value, " + name + " must come after SCENE"
                            : "");
        }
        return mistake.getMessage().replaceFirst("^Error: ", "").replaceAll("\\[-[^{]*=(?=\\{)", "");
    }

    private static String unmatched(UnmatchedArgumentException mistake, CommandSpec command, String first) {
        if (command.parent() == null && !first.startsWith("-") && Files.notExists(Path.of(first))) {
            return TompkinsCommand.unknownWord(first);
        }
        if (!mistake.isUnknownOption()) {
            return "too many arguments: " + String.join(" ", mistake.getUnmatched());
        }
        String option = mistake.getUnmatched().get(0).replaceFirst("(?s)=.*", "");
        List<String> owners = command.subcommands().values().stream()
                .filter(other -> other.getCommandSpec().findOption(option) != null)
                .map(CommandLine::getCommandName)
                .toList();
        if (!owners.isEmpty()) {
            return option + " is an option of " + String.join(", ", owners) + "; write the command before it";
        }
        String word = option.replaceFirst("^-+", "");
        // the help begins with the word that says it best
        String like = command.options().stream()
                .filter(known -> known.description()[0].startsWith(word + " "))
                .map(OptionSpec::longestName)
                .findFirst()
                .orElse(option);
        String hint = Spelling.hint(like, command.optionsMap().keySet());
        boolean mayBeKey = hint.isEmpty() && command.findOption(SetOption.NAME) != null;
        return "unknown option " + option + (mayBeKey ? Assignments.hint(word) : hint);
    }
}
