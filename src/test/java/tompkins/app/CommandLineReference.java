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
        commands.forEach((name, command) -> rows(command)
                .forEach(row ->
                        users.computeIfAbsent(row, first -> new ArrayList<>()).add(name)));
        StringBuilder text = new StringBuilder(introduction());
        Map<String, List<String>> shared = new LinkedHashMap<>();
        users.forEach((row, names) -> {
            if (names.size() > 1) {
                shared.computeIfAbsent(String.join(", ", names), all -> new ArrayList<>())
                        .add(row);
            }
        });
        text.append("\n## Arguments of several commands\n");
        shared.forEach((names, rows) -> {
            text.append("\nOf ").append(names).append(":\n\n");
            append(text, rows);
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
            return new String(in.readAllBytes(), StandardCharsets.UTF_8).replace("\r\n", "\n");
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }

    private static void append(StringBuilder text, String name, CommandLine command, Predicate<String> isOwn) {
        CommandSpec spec = command.getCommandSpec();
        text.append("\n## `tompkins ").append(name).append("`\n\n");
        text.append(String.join(" ", spec.usageMessage().header())).append("\n\n");
        List<String> rows = rows(command).filter(isOwn).toList();
        if (!rows.isEmpty()) {
            append(text, rows);
        }
    }

    private static void append(StringBuilder text, List<String> rows) {
        rows.forEach(row -> text.append(row).append('\n'));
    }

    private static Stream<String> rows(CommandLine command) {
        CommandSpec spec = command.getCommandSpec();
        return Stream.concat(
                spec.positionalParameters().stream().map(argument -> row(argument.paramLabel(), argument)),
                spec.options().stream()
                        .filter(option -> !option.usageHelp() && !option.versionHelp())
                        .map(CommandLineReference::row));
    }

    private static String row(OptionSpec option) {
        String label = option.paramLabel();
        String value = option.arity().max() == 0 ? "" : option.arity().min() == 0 ? "[=" + label + "]" : "=" + label;
        return row(String.join(", ", option.names()) + value, option);
    }

    private static String row(String name, ArgSpec argument) {
        return "- `" + name + "`: " + String.join(" ", argument.description());
    }
}
