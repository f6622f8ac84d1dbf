package tompkins.app;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import picocli.CommandLine;
import picocli.CommandLine.Help;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;

/** The reference of the command line, made from the commands. */
final class CommandLineReference {

    private static final String INTRODUCTION = "command-line.md";

    private CommandLineReference() {}

    /** The reference as Markdown, with line feeds as line ends. */
    static String markdown() {
        Map<String, CommandLine> commands = commands();
        Map<String, List<String>> users = new LinkedHashMap<>();
        commands.forEach((name, command) -> options(command)
                .forEach(option -> users.computeIfAbsent(row(option), row -> new ArrayList<>())
                        .add(name)));
        StringBuilder text = new StringBuilder(introduction());
        text.append("\n## Options of several commands\n\n| option | meaning | commands |\n|---|---|---|\n");
        users.forEach((row, names) -> {
            if (names.size() > 1) {
                text.append(row).append(' ').append(String.join(", ", names)).append(" |\n");
            }
        });
        commands.forEach((name, command) ->
                append(text, name, command, row -> users.get(row).size() == 1));
        return text.toString();
    }

    /** The commands by name, without the one that shows help. */
    static Map<String, CommandLine> commands() {
        Map<String, CommandLine> all = TompkinsCommand.withAllCommands().getSubcommands();
        return all.entrySet().stream()
                .filter(command -> !command.getKey().equals(TompkinsCommand.HELP))
                .collect(Collectors.toMap(
                        Map.Entry::getKey, Map.Entry::getValue, (one, other) -> one, LinkedHashMap::new));
    }

    private static String introduction() {
        try (InputStream in = CommandLineReference.class.getResourceAsStream(INTRODUCTION)) {
            String shorts = SceneOptions.PATHS.entrySet().stream()
                    .map(option -> "| `" + option.getKey() + "` | `" + option.getValue() + "` |")
                    .sorted()
                    .collect(Collectors.joining("\n"));
            return new String(in.readAllBytes(), StandardCharsets.UTF_8)
                    .replace("\r\n", "\n")
                    .replace("@SHORT@", """
                            | option | path |
                            |---|---|
                            | `--beta` | `velocity.beta`, or `velocity` with three numbers |
                            | `--samples` | `settings.samples`, without a `targetError` |
                            | `--error` | `settings.targetError` |
                            | `--size` | `settings.width` and `settings.height` |
                            """ + shorts);
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }

    private static void append(StringBuilder text, String name, CommandLine command, Predicate<String> isOwn) {
        CommandSpec spec = command.getCommandSpec();
        text.append("\n## `tompkins ").append(name).append("`\n\n");
        text.append(Stream.of(spec.usageMessage().header(), spec.usageMessage().description())
                        .flatMap(Stream::of)
                        .collect(Collectors.joining(" ")))
                .append("\n\n");
        new Help(spec, Help.defaultColorScheme(Help.Ansi.OFF))
                .synopsis(0)
                .lines()
                .forEach(line -> text.append("    ").append(line).append('\n'));
        text.append("\n| argument | meaning |\n|---|---|\n");
        spec.positionalParameters()
                .forEach(argument ->
                        text.append(row(argument.paramLabel(), argument)).append('\n'));
        options(command)
                .map(CommandLineReference::row)
                .filter(isOwn)
                .forEach(row -> text.append(row).append('\n'));
    }

    private static Stream<OptionSpec> options(CommandLine command) {
        return command.getCommandSpec().options().stream()
                .filter(option -> !option.usageHelp() && !option.versionHelp());
    }

    private static String row(OptionSpec option) {
        String label = option.paramLabel();
        String value = option.arity().max() == 0 ? "" : option.arity().min() == 0 ? "[=" + label + "]" : "=" + label;
        return row(String.join(", ", option.names()) + value, option);
    }

    private static String row(String name, ArgSpec argument) {
        return Stream.of("`" + name + "`", String.join(" ", argument.description()))
                .map(cell -> cell.replace("|", "\\|"))
                .collect(Collectors.joining(" | ", "| ", " |"));
    }
}
