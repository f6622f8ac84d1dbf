package tompkins.app;

import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;
import tompkins.property.MistakeException;

/** Shows the help of the program, or of one of its commands. */
@Command(header = "Shows the help of a command.", description = "Without COMMAND: lists all commands.")
final class HelpCommand extends ProgramCommand {

    @Parameters(arity = "0..1", paramLabel = "COMMAND", description = "name of a command")
    private String name;

    @Override
    public Integer call() {
        CommandLine program = TompkinsCommand.withAllCommands();
        CommandLine wanted = name == null ? program : program.getSubcommands().get(name);
        if (wanted == null) {
            throw new MistakeException(
                    TompkinsCommand.unknownWord(name, program.getSubcommands().keySet()));
        }
        wanted.usage(out());
        return 0;
    }
}
