package tompkins.app;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.HelpCommand;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import tompkins.io.StudioReader;
import tompkins.ui.Displays;
import tompkins.ui.TompkinsWindow;

/** The program as a whole. */
@Command(
        name = "tompkins",
        mixinStandardHelpOptions = true,
        versionProvider = ProgramVersion.class,
        description = "Takes photographs with a camera that moves at nearly the speed of light.",
        footer = {
            "",
            "Without a command: opens the window, with a scene file or saved photograph if one is given; without a display,"
                    + " takes the photograph."
        },
        subcommands = {
            RenderCommand.class,
            CheckCommand.class,
            ExplainCommand.class,
            TraceCommand.class,
            StudyCommand.class,
            HelpCommand.class
        })
final class TompkinsCommand implements Callable<Integer> {

    @Parameters(arity = "0..1", paramLabel = "SCENE", description = "scene file or saved photograph to open")
    private Path scene;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws Exception {
        if (scene != null && !Files.exists(scene)) {
            throw new MistakeException(ArgumentMistake.unknownWord(scene.toString(), spec));
        }
        Path file = scene == null ? BundledScenes.file("fig1b.json") : scene;
        if (Displays.usable()) {
            TompkinsWindow.open(StudioReader.read(file), scene, BundledScenes::studios, new WindowCommandLine());
            return Failures.WINDOW_IS_OPEN;
        }
        spec.commandLine()
                .getErr()
                .println("There is no display: taking the photograph instead of opening the window.");
        new Photographer(spec.commandLine(), 0).takeDefault(file, Path.of(""));
        return 0;
    }
}
