package tompkins.app;

import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import tompkins.camera.Camera;
import tompkins.io.StudioReader;
import tompkins.property.NumberText;
import tompkins.property.OneLine;
import tompkins.render.CostForecast;
import tompkins.render.Quality;
import tompkins.render.Renderer;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/** Says what a picture needs and what it leaves out. */
@Command(
        mixinStandardHelpOptions = true,
        versionProvider = ProgramVersion.class,
        description = "Says what the picture of a scene models, what it leaves out, and why, and what it will cost.")
final class ExplainCommand implements Callable<Integer>, SceneCommand {

    private static final double MILLION = 1e6;

    @Parameters(paramLabel = "SCENE", description = "scene file, or saved photograph")
    private Path scene;

    @Mixin
    private StudioOptions options;

    @Mixin
    private QualityOptions quality;

    @Spec
    private CommandSpec spec;

    @Override
    public Path scene() {
        return scene;
    }

    @Override
    public Integer call() throws InterruptedException {
        Studio studio = quality.applyTo(options.applyTo(StudioReader.read(scene)));
        RenderPlan plan = ScenePlan.of(studio, scene);
        // everything that may be refused comes before the first word
        Quality wish = quality.of(studio);
        Photographer.requireMemory(studio.settings(), wish);
        spec.commandLine().getOut().println(OneLine.of(studio.title()));
        studio.remarks().lines().map(OneLine::of).forEach(spec.commandLine().getOut()::println);
        for (String sentence : plan.sentences()) {
            spec.commandLine().getOut().println("- " + sentence);
        }
        spec.commandLine().getOut().println("- " + wish.sentence(plan));
        spec.commandLine().getOut().println("- " + cost("On this machine it will", plan, wish));
        if (plan.blursInTime()) {
            Camera instant = studio.camera().withExposureTime(0);
            RenderPlan sharp = RenderPlan.of(studio.withCamera(instant));
            spec.commandLine().getOut().println("- " + cost("Opened for an instant it would", sharp, wish));
        }
        return 0;
    }

    private static String cost(String beginning, RenderPlan plan, Quality quality) throws InterruptedException {
        try (Renderer renderer = new Renderer()) {
            return CostForecast.of(plan, quality, renderer)
                    .map(forecast -> beginning + cost(plan, quality, forecast))
                    .orElse(beginning + " take too long to predict:"
                            + " after several seconds not one sample was complete.");
        }
    }

    private static String cost(RenderPlan plan, Quality quality, CostForecast forecast) {
        double samples = forecast.samplesPerPixel() * plan.width() * plan.height();
        return String.format(
                Locale.ROOT,
                " take about %s s with %s samples, %s per pixel.",
                NumberText.plain(forecast.seconds(), 2),
                samples < MILLION
                        ? NumberText.plain(samples, quality instanceof Quality.Samples ? 6 : 3)
                        : NumberText.plain(samples / MILLION, 3) + " million",
                NumberText.plain(forecast.samplesPerPixel(), 3));
    }
}
