package tompkins.app;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.function.Function;
import java.util.stream.Stream;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import tompkins.animation.Animation;
import tompkins.animation.AnimationRecorder;
import tompkins.animation.StudioNumber;
import tompkins.image.AnimationFormat;
import tompkins.image.AnimationWriter;
import tompkins.image.FileException;
import tompkins.io.StudioReader;
import tompkins.property.InvalidPropertyException;
import tompkins.property.Require;
import tompkins.render.Quality;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;
import tompkins.ui.Captions;

/** Saves animations of a number of a scene. */
@Command(
        mixinStandardHelpOptions = true,
        versionProvider = ProgramVersion.class,
        description =
                "Takes photographs while a number of the scene, such as the speed of the camera, runs from one value"
                        + " to another, and saves them as an animation.")
final class AnimateCommand implements Callable<Integer>, SceneCommand {

    @Parameters(paramLabel = "SCENE", description = "scene file, or saved photograph")
    private Path scene;

    @Option(
            names = {"-o", "--output"},
            required = true,
            paramLabel = "FILE",
            description =
                    "the animation: .png or .apng (exact), .gif (256 colours), .mp4 (if ffmpeg is installed); a name"
                            + " without an ending is a new folder of numbered pictures")
    private Path output;

    @Option(
            names = "--number",
            defaultValue = "velocity.beta",
            paramLabel = "PLACE",
            description =
                    "place of the number in the scene file, such as velocity.rapidity, camera.shutter.openingTime or"
                            + " scene[0].centre.x; default: ${DEFAULT-VALUE}, the speed")
    private String number;

    @Option(names = "--from", required = true, paramLabel = "A", description = "value at the beginning")
    private double from;

    @Option(
            names = "--to",
            required = true,
            paramLabel = "B",
            description = "value at the end, or in the middle of an animation there and back")
    private double to;

    @Option(
            names = "--duration",
            defaultValue = "4",
            paramLabel = "S",
            description = "seconds that it plays, from 0.1 to 600; default: ${DEFAULT-VALUE}")
    private double seconds;

    @Option(
            names = "--fps",
            defaultValue = "" + Animation.FRAME_RATE,
            paramLabel = "N",
            description = "pictures a second, from 1 to 60; default: ${DEFAULT-VALUE}")
    private int frameRate;

    @Option(names = "--back", description = "go back to the first value in the same time, so that it can run in a loop")
    private boolean back;

    @Option(names = "--caption", description = "write beta, gamma and the number into the pictures")
    private boolean captioned;

    @Option(names = "--force", description = "replace a file that is already there")
    private boolean force;

    @ArgGroup
    private QualityWish quality = new QualityWish();

    @Mixin
    private PictureOptions picture;

    @Mixin
    private StudioOptions options;

    @Spec
    private CommandSpec spec;

    @Override
    public Path scene() {
        return scene;
    }

    @Override
    public Integer call() throws IOException, InterruptedException {
        Studio studio = picture.applyTo(quality.applyTo(options.applyTo(StudioReader.read(scene))));
        Animation animation = animation(studio);
        Set<String> warnings = new LinkedHashSet<>(requirePossible(studio, animation));
        long start = System.nanoTime();
        PrintWriter err = spec.commandLine().getErr();
        ProgressLine progress = new ProgressLine(err);
        Path place;
        try (AnimationWriter writer = open(animation)) {
            Function<Studio, String> caption = Captions.ofPictures(studio, animation.number(), captioned);
            warnings.addAll(AnimationRecorder.record(studio, animation, writer, caption, progress)
                    .sentences());
            place = writer.finish();
        } finally {
            progress.clear();
        }
        warnings.forEach(warning -> err.println("warning: " + warning));
        spec.commandLine()
                .getOut()
                .println(String.format(
                        Locale.ROOT,
                        "%s  (%.2f s, %d pictures)",
                        place.toRealPath(LinkOption.NOFOLLOW_LINKS),
                        (System.nanoTime() - start) / 1e9,
                        animation.frames()));
        Photographer.tellFilesToKeep(studio, err);
        return 0;
    }

    private Animation animation(Studio studio) {
        StudioNumber animated = MistakeException.inOption("--number", () -> StudioNumber.at(number, studio));
        double duration = MistakeException.inOption(
                "--duration", () -> Require.within("duration", seconds, Animation.SHORTEST, Animation.LONGEST));
        int rate = MistakeException.inOption(
                "--fps", () -> Require.within("fps", frameRate, 1, Animation.HIGHEST_FRAME_RATE));
        Animation.Course course = back ? Animation.Course.THERE_AND_BACK : Animation.Course.FORWARDS;
        return new Animation(animated, from, to, duration, course, rate);
    }

    /**
     * Finds the mistakes of all pictures first: nobody wants to hear of the last one after the others took an hour.
     *
     * @return warnings about the scene at both ends
     */
    private List<String> requirePossible(Studio studio, Animation animation) {
        Studio first = with("--from", from, studio, animation.number());
        Studio last = with("--to", to, studio, animation.number());
        Photographer.info(first, scene);
        RenderPlan begin = ScenePlan.of(first, scene);
        RenderPlan end = ScenePlan.of(last, begin, scene);
        for (int i = 0; i < animation.frames(); i++) {
            with("--number " + number, animation.value(animation.timeOf(i)), studio, animation.number());
        }
        Photographer.requireMemory(studio.settings(), Quality.of(studio));
        if (!force) {
            Photographer.requireFree(output);
        }
        return Stream.concat(begin.warnings().stream(), end.warnings().stream()).toList();
    }

    /** The studio with another value, which an option has brought. */
    private static Studio with(String option, double value, Studio studio, StudioNumber number) {
        try {
            return number.with(studio, value);
        } catch (InvalidPropertyException refused) {
            throw new MistakeException(option + ": " + refused.getMessage());
        }
    }

    private AnimationWriter open(Animation animation) {
        try {
            AnimationFormat format =
                    OutputOption.namesFolder(spec) ? AnimationFormat.NUMBERED_PNG : AnimationFormat.of(output);
            int rate = animation.frameRate();
            return force ? format.open(output, rate) : format.openNew(output, rate);
        } catch (FileException wrongPlace) {
            // no disk has failed yet: the user named the place
            throw new MistakeException(wrongPlace.getMessage());
        }
    }
}
