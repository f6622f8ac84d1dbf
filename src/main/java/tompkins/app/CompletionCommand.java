package tompkins.app;

import picocli.AutoComplete;
import picocli.CommandLine.Command;

/** Prints a script with which a shell completes commands and options. */
@Command(
        header = "Prints a script that completes commands in bash and zsh.",
        description = "Prints a script for bash and zsh: \"source <(tompkins completion)\" makes the Tab key complete"
                + " commands, options and names of files.")
final class CompletionCommand extends ProgramCommand {

    @Override
    public Integer call() {
        AutoComplete.bash(TompkinsCommand.NAME, TompkinsCommand.withAllCommands())
                .lines()
                .forEach(out()::println);
        return 0;
    }
}
