package tompkins.app;

import java.nio.file.Path;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import tompkins.io.StudioReader;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/** Says what a picture needs and what it leaves out. */
@Command(
        name = "explain",
        mixinStandardHelpOptions = true,
        description = "Says what the picture of a scene models, what it leaves out, and why.")
final class ExplainCommand implements Callable<Integer> {

    @Parameters(paramLabel = "SCENE", description = "scene file, or saved photograph")
    private Path scene;

    @Mixin
    private StudioOptions options;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        Studio studio = options.applyTo(StudioReader.read(scene));
        spec.commandLine().getOut().println(studio.title());
        for (String sentence : RenderPlan.of(studio).sentences()) {
            spec.commandLine().getOut().println("- " + sentence);
        }
        return 0;
    }
}
