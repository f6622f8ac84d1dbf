package tompkins.app;

import java.nio.file.Path;
import java.util.Locale;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;
import tompkins.explain.Explanation;
import tompkins.measure.UnseenObjects;
import tompkins.property.NumberText;
import tompkins.render.CostForecast;
import tompkins.render.Quality;
import tompkins.render.Renderer;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;
import tompkins.trace.TouchingSurfaces;

/** Says what a picture needs and what it leaves out. */
@Command(header = "Says what a picture models and leaves out, and what it will cost.")
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
        Renderer.requireMemory(studio.settings(), wish);
        out().println(studio.title());
        studio.remarks().lines().forEach(out()::println);
        new Explanation(plan).sentences().forEach(sentence -> out().println("- " + sentence));
        UnseenObjects unseen = new UnseenObjects(plan);
        unseen.sentence().ifPresent(sentence -> out().println("- " + sentence));
        unseen.warning().ifPresent(warning -> out().println("- Warning: " + warning + "."));
        TouchingSurfaces touching = new TouchingSurfaces(plan);
        touching.media().forEach(sentence -> out().println("- " + sentence));
        touching.rivals().forEach(clause -> out().println("- Warning: " + clause + "."));
        out().println("- " + wish.sentence(plan));
        out().println("- " + cost(plan, wish));
        return 0;
    }

    private static String cost(RenderPlan plan, Quality quality) throws InterruptedException {
        try (Renderer renderer = new Renderer()) {
            return CostForecast.of(plan, quality, renderer)
                    .map(forecast -> "On this machine it will" + cost(plan, quality, forecast))
                    .orElse("On this machine it will take too long to predict:"
                            + " after several seconds not one sample was complete.");
        }
    }

    private static String cost(RenderPlan plan, Quality quality, CostForecast forecast) {
        boolean isFixed = quality instanceof Quality.Samples;
        double samples = forecast.samplesPerPixel() * plan.width() * plan.height();
        return String.format(
                Locale.ROOT,
                " take %s with %s samples, %s%s per pixel.",
                quality instanceof Quality.TimeLimit limit
                        ? NumberText.of(limit.seconds()) + " s"
                        : forecast.duration(),
                samples < MILLION
                        ? NumberText.plain(samples, isFixed ? 6 : 2)
                        : NumberText.plain(samples / MILLION, isFixed ? 3 : 2) + " million",
                isFixed ? "" : "about ",
                NumberText.plain(forecast.samplesPerPixel(), isFixed ? 3 : 2));
    }
}
