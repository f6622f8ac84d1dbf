package tompkins.app;

import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Lets a command that computes for long tell a program how far it is. */
final class ProgressOption {

    /** The languages of programs. */
    enum Form {
        JSON
    }

    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    // called when the option is read
    @SuppressWarnings("unused")
    @Option(names = "--progress", paramLabel = "json", description = "tell on the error stream how far it is, in JSON")
    private void setForm(Form json) {
        CommandLine line = command.commandLine();
        line.setErr(new JsonLines(line.getErr()));
    }
}
