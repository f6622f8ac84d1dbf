package tompkins.app;

import java.util.ArrayList;
import java.util.List;
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
        int keys = 4 + type.keys().stream().mapToInt(key -> key.name().length()).max().orElse(0);
        int width = commandLine().getUsageHelpWidth();
        TextTable table = TextTable.forColumns(
                commandLine().getColorScheme(),
                new Column(keys, 2, Column.Overflow.TRUNCATE),
                new Column(width - keys, 2, Column.Overflow.WRAP));
        type.keys().forEach(key -> table.addRowValues(key.name(), told(key)));
        TextTable head = TextTable.forColumns(
                commandLine().getColorScheme(), new Column(width, 0, Column.Overflow.WRAP));
        head.addRowValues(type.name() + ": " + type.meaning() + ".");
        (head.toString() + table).lines().forEach(out()::println);
    }

    private static String told(TypeReference.Key key) {
        return key.meaning() + " (" + key.value()
                + (key.allowed().isEmpty() ? "" : ", " + key.allowed())
                + (key.unit().isEmpty() ? "" : ", unit: " + key.unit())
                + (key.standard().isEmpty() ? "" : "; default: " + key.standard()) + ")";
    }
}
