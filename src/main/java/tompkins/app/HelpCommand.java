package tompkins.app;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Help.Column;
import picocli.CommandLine.Help.TextTable;
import picocli.CommandLine.Parameters;
import tompkins.io.Spelling;
import tompkins.io.TypeReference;
import tompkins.property.MistakeException;

/** Shows the help of the program, of one of its commands, or of a type of scene files. */
@Command(
        header = "Shows the help of a command, or of a type of scene files.",
        description = "Without NAME: lists all commands.")
final class HelpCommand extends ProgramCommand {

    @Parameters(
            arity = "0..1",
            paramLabel = "NAME",
            description = "name of a command, or of a type such as Sphere, Surface or Studio, which is a whole scene")
    private String name;

    @Override
    public Integer call() {
        CommandLine program = TompkinsCommand.withAllCommands();
        CommandLine wanted = name == null ? program : program.getSubcommands().get(name);
        if (wanted != null) {
            wanted.usage(out());
            return 0;
        }
        List<TypeReference> types = TypeReference.of(name);
        if (types.isEmpty()) {
            List<String> names = new ArrayList<>(program.getSubcommands().keySet());
            names.addAll(TypeReference.names());
            throw new MistakeException(OptionValues.shown(name) + ": there is neither a command nor a type of this name"
                    + Spelling.hint(name, names) + "; \"help\" lists the commands, \"help Studio\" what a scene holds");
        }
        types.forEach(this::print);
        return 0;
    }

    private void print(TypeReference type) {
        out().println(type.name() + (type.family().isEmpty() ? "" : " (" + type.family() + ")"));
        TextTable meaning =
                TextTable.forColumns(commandLine().getColorScheme(), new Column(width(), 2, Column.Overflow.WRAP));
        meaning.indentWrappedLines = 0;
        meaning.addRowValues(type.meaning() + ".");
        print(meaning);
        Map<String, String> words = new LinkedHashMap<>(type.members());
        type.keys().forEach(key -> words.put(key.name(), key.meaning() + "\n" + value(key)));
        print(words);
        if (!type.example().isEmpty()) {
            out().println("  Example:");
            type.example().lines().map(line -> "    " + line).forEach(out()::println);
            out().println();
        }
    }

    /** Prints words, and beside each what it means. */
    private void print(Map<String, String> meanings) {
        int words =
                4 + meanings.keySet().stream().mapToInt(String::length).max().orElse(0);
        TextTable table = TextTable.forColumns(
                commandLine().getColorScheme(),
                new Column(words, 2, Column.Overflow.TRUNCATE),
                new Column(width() - words, 2, Column.Overflow.WRAP));
        meanings.forEach(table::addRowValues);
        print(table);
    }

    private void print(TextTable table) {
        table.toString().lines().forEach(out()::println);
        out().println();
    }

    private int width() {
        return commandLine().getUsageHelpWidth();
    }

    /** The values of a key: "a number from 0 to 1; unit: time; default: 0". */
    private static String value(TypeReference.Key key) {
        String allowed = key.allowed();
        boolean isTold = key.value().contains("number") && allowed.contains("number");
        String joint = allowed.matches("(from|above) .*") ? " " : ", ";
        return (isTold ? allowed : allowed.isEmpty() ? key.value() : key.value() + joint + allowed)
                + (key.unit().isEmpty() ? "" : "; unit: " + key.unit())
                + (key.standard().isEmpty() ? "" : "; default: " + key.standard());
    }
}
