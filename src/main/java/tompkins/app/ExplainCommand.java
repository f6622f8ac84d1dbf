package tompkins.app;

import java.nio.file.Path;
import java.util.Locale;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;
import tompkins.camera.Camera;
import tompkins.explain.Explanation;
import tompkins.property.NumberText;
import tompkins.render.CostForecast;
import tompkins.render.Quality;
import tompkins.render.Renderer;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;
import tompkins.trace.TouchingSurfaces;

/** Says what a picture needs and what it leaves out. */
@Command(description = "Says what the picture of a scene models, what it leaves out, and why, and what it will cost.")
final class ExplainCommand extends ProgramCommand {

    private static final double MILLION = 1e6;

    @Parameters(paramLabel = "SCENE", description = "scene file, or saved photograph; - is the standard input")
    private Path scene;

    @Mixin
    private SampledOptions options;

    @Mixin
    private QualityOptions quality;

    @Override
    public Integer call() throws InterruptedException {
        Studio studio = options.read(scene, quality.assignments());
        RenderPlan plan = ScenePlan.of(studio, scene);
        // everything that may be refused comes before the first word
        Quality wish = quality.of(studio);
        Photographer.requireMemory(studio.settings(), wish);
        out().println(studio.title());
        studio.remarks().lines().forEach(out()::println);
        for (String sentence : new Explanation(plan).sentences()) {
            out().println("- " + sentence);
        }
        TouchingSurfaces touching = new TouchingSurfaces(plan);
        touching.media().forEach(sentence -> out().println("- " + sentence));
        touching.rivals().forEach(clause -> out().println("- Warning: " + clause + "."));
        out().println("- " + wish.sentence(plan));
        out().println("- " + cost("On this machine it will", plan, wish));
        if (plan.blursInTime()) {
            Camera instant = studio.camera().withExposureTime(0);
            RenderPlan sharp = RenderPlan.of(studio.withCamera(instant));
            out().println("- " + cost("Opened for an instant it would", sharp, wish));
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
                " take %s with %s samples, %s per pixel.",
                forecast.duration(),
                samples < MILLION
                        ? NumberText.plain(samples, quality instanceof Quality.Samples ? 6 : 3)
                        : NumberText.plain(samples / MILLION, 3) + " million",
                NumberText.plain(forecast.samplesPerPixel(), 3));
    }
}
