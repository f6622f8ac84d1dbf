package tompkins.app;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import picocli.CommandLine;
import picocli.CommandLine.MaxValuesExceededException;
import picocli.CommandLine.MissingParameterException;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;
import picocli.CommandLine.MutuallyExclusiveArgsException;
import picocli.CommandLine.OverwrittenOptionException;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.TypeConversionException;
import picocli.CommandLine.UnmatchedArgumentException;
import tompkins.io.Spelling;
import tompkins.studio.Studio;
import tompkins.studio.StudioPath;

/** Says what is wrong with arguments in the words of the user; the library that reads them speaks of Java. */
final class ArgumentMistake {

    /** Keys of scenes that lie deeper are not looked for among options. */
    private static final int DEEPEST_KEY = 2;

    private ArgumentMistake() {}

    /** What is wrong, and what is allowed. */
    static String message(ParameterException mistake, String[] arguments) {
        CommandSpec command = mistake.getCommandLine().getCommandSpec();
        if (mistake instanceof MissingParameterException missing) {
            return missing.getMissing().get(0) instanceof OptionSpec option && !isNeeded(option)
                    ? option.longestName() + " needs " + value(option)
                    : fileLikeOption(arguments)
                            .or(() -> unknownOption(command, arguments))
                            .orElse("needs " + wordsBefore(missing.getMissing().get(0))
                                    + explained(missing.getMissing()));
        }
        if (mistake.getCause() instanceof InvalidPathException notAName) {
            return NamedFile.mistake(notAName);
        }
        if (mistake instanceof OverwrittenOptionException twice
                && twice.getOverwritten() instanceof OptionSpec option) {
            return option.longestName() + " may be given only once";
        }
        if (mistake.getArgSpec() instanceof OptionSpec option && mistake.getValue() != null) {
            return withWrongValue(option, mistake);
        }
        if (mistake instanceof UnmatchedArgumentException unmatched) {
            return unmatched(unmatched, command, arguments);
        }
        if (mistake instanceof MutuallyExclusiveArgsException || mistake instanceof MaxValuesExceededException) {
            return onlyOneOf(command, mistake);
        }
        return mistake.getMessage();
    }

    /** What is wrong with a word in the place of a command or a scene. */
    static String unknownWord(String word, CommandSpec command) {
        return word + ": there is neither a file nor a command of this name" + commands(word, command);
    }

    /** What is wrong with a word in the place of a command. */
    static String unknownCommand(String word, CommandSpec program) {
        return OptionValues.shown(word) + ": there is no command of this name" + commands(word, program);
    }

    private static String commands(String word, CommandSpec command) {
        Set<String> names = command.subcommands().keySet();
        return "; the commands are " + String.join(", ", names) + Spelling.hint(word, names);
    }

    /** Whether the command needs an option. The library says so, too, of options that exclude each other. */
    private static boolean isNeeded(OptionSpec option) {
        return option.required() && option.group() == null;
    }

    /** The arguments that stand before a missing one, which may have been left out in its stead. */
    private static String wordsBefore(ArgSpec missing) {
        List<PositionalParamSpec> all = missing.command().positionalParameters();
        return all.stream()
                .limit(Math.max(0, all.indexOf(missing)))
                .map(word -> word.paramLabel() + " and ")
                .collect(Collectors.joining());
    }

    private static String explained(List<ArgSpec> missing) {
        return missing.stream()
                .map(argument ->
                        (argument instanceof OptionSpec option ? option.longestName() + "=" : "") + value(argument))
                .collect(Collectors.joining("; and "));
    }

    private static String value(ArgSpec argument) {
        return argument.paramLabel() + ": " + description(argument);
    }

    /** What the help says about an option or another argument. */
    private static String description(ArgSpec argument) {
        return String.join(" ", argument.description());
    }

    private static String withWrongValue(OptionSpec option, ParameterException mistake) {
        String name = option.longestName();
        String value = OptionValues.shown(mistake.getValue());
        if (option.arity().max() == 0) {
            return name + " is given without a value, was " + value;
        }
        String alone = option.arity().min() == 0 ? "; without a number it must come after SCENE" : "";
        return mistake.getCause() instanceof TypeConversionException refused
                ? name + " must be " + refused.getMessage() + ", was " + value + alone
                : mistake.getMessage();
    }

    /** What to say if the name of a file begins like an option. */
    private static Optional<String> fileLikeOption(String... words) {
        return Stream.of(words)
                .filter(word -> word.startsWith("-") && new File(word).exists())
                .findFirst()
                .map(word -> word + ": what begins with - is read as an option; to name the file, write ."
                        + File.separator + word);
    }

    private static String unmatched(UnmatchedArgumentException unmatched, CommandSpec command, String[] arguments) {
        boolean beforeCommands = command.parent() == null;
        String first = arguments[0];
        if (beforeCommands && !first.startsWith("-") && Files.notExists(Path.of(first))) {
            return unknownWord(first, command);
        }
        String wrong = unmatched.getUnmatched().get(0);
        if (!unmatched.isUnknownOption()) {
            return "too many arguments: " + String.join(" ", unmatched.getUnmatched());
        }
        String name = name(wrong);
        String owners = command.subcommands().values().stream()
                .map(CommandLine::getCommandSpec)
                .filter(owner -> owner.findOption(name) != null)
                .map(CommandSpec::name)
                .collect(Collectors.joining(", "));
        if (!owners.isEmpty()) {
            return name + " is an option of " + owners + "; write the command before it";
        }
        return fileLikeOption(wrong).orElseGet(() -> unknown(name, command));
    }

    private static String unknown(String option, CommandSpec command) {
        String key = option.replaceFirst("^-+", "");
        return "unknown option " + option
                + (command.findOption(SetOption.NAME) == null || key.length() < 2
                                ? Optional.<String>empty()
                                : pathOfKey(key, Studio.DEFAULT, DEEPEST_KEY))
                        .map(path -> "; did you mean \"" + SetOption.NAME + " " + path + "=VALUE\"?")
                        .orElseGet(() -> hint(option, command.options()));
    }

    /** The way to a key of a scene, at most so many steps below what holds it. */
    private static Optional<String> pathOfKey(String key, Object whole, int depth) {
        List<String> steps = StudioPath.stepsFrom(whole).stream()
                .filter(step -> !step.startsWith("["))
                .toList();
        if (steps.contains(key) || depth == 0) {
            return Optional.of(key).filter(steps::contains);
        }
        return steps.stream()
                .flatMap(step ->
                        pathOfKey(key, StudioPath.ROOT.then(step).get(whole), depth - 1)
                                .map(rest -> step + "." + rest)
                                .stream())
                .findFirst();
    }

    /**
     * What to say of the first word that looks like an option and is none; the library looks for what is missing first.
     */
    private static Optional<String> unknownOption(CommandSpec command, String... words) {
        return Stream.of(words)
                .filter(word -> word.matches("(?s)--?[A-Za-z].*"))
                .map(word -> word.startsWith("--") ? name(word) : word.substring(0, 2))
                .filter(name -> command.findOption(name) == null)
                .findFirst()
                .map(name -> unknown(name, command));
    }

    /** The name of an option, without the value behind it. */
    private static String name(String option) {
        return option.replaceFirst("=.*", "");
    }

    /**
     * A hint at the option whose description begins with the word of the wrong one, or else at one with a similar name.
     */
    private static String hint(String wrong, List<OptionSpec> options) {
        String start = wrong.replaceFirst("^--", "") + " ";
        String meant = options.stream()
                .filter(option -> description(option).startsWith(start))
                .map(OptionSpec::longestName)
                .findFirst()
                .orElse(wrong);
        return Spelling.hint(
                meant,
                options.stream().flatMap(option -> Stream.of(option.names())).toList());
    }

    private static String onlyOneOf(CommandSpec command, ParameterException mistake) {
        return command.argGroups().stream()
                .map(group -> group.allOptionsNested().stream()
                        .map(OptionSpec::longestName)
                        .toList())
                .filter(names -> names.stream().anyMatch(mistake.getMessage()::contains))
                .map(names -> String.join(", ", names))
                .findFirst()
                .map(names -> "only one of " + names + " may be given, and only once")
                .orElse(mistake.getMessage());
    }
}
