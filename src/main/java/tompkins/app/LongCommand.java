package tompkins.app;

import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** A command that computes for long: with so many threads, and it can tell another program how far it is. */
abstract class LongCommand extends ProgramCommand {

    /** The languages of programs. */
    enum ProgressForm {
        JSON
    }

    @Mixin
    private ThreadsOption threads;

    // called when the option is read, so that all that follows is told in that form
    @SuppressWarnings("unused")
    @Option(names = "--progress", paramLabel = "json", description = "report progress on the error stream, in JSON")
    private void setProgress(ProgressForm json) {
        commandLine().setErr(new JsonLines(err()));
    }

    /** The threads that it uses. */
    final ThreadsOption threads() {
        return threads;
    }
}
