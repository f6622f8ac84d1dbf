package tompkins.app;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.Spec;
import tompkins.animation.Animation;
import tompkins.animation.AnimationRecorder;
import tompkins.animation.Film;
import tompkins.animation.RideFilm;
import tompkins.image.AnimationFormat;
import tompkins.image.AnimationWriter;
import tompkins.image.FileException;
import tompkins.image.PictureDecoration;
import tompkins.io.StudioReader;
import tompkins.property.InvalidPropertyException;
import tompkins.property.Require;
import tompkins.render.Quality;
import tompkins.studio.RideLeg;
import tompkins.studio.Studio;
import tompkins.studio.StudioNumber;
import tompkins.trace.RenderPlan;
import tompkins.ui.Captions;

/** Saves animations of a number of a scene. */
@Command(
        mixinStandardHelpOptions = true,
        versionProvider = ProgramVersion.class,
        description =
                "Takes photographs while a number of the scene, such as the speed of the camera, runs from one value"
                        + " to another, or along a recorded ride, and saves them as an animation.")
final class AnimateCommand implements Callable<Integer>, SceneCommand {

    /** How long it plays unless an option says otherwise. */
    private static final double DEFAULT_SECONDS = 4;

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

    @Option(names = "--from", paramLabel = "A", description = "value at the beginning")
    private Double from;

    @Option(
            names = "--to",
            paramLabel = "B",
            description = "value at the end, or in the middle of an animation there and back")
    private Double to;

    @Option(names = "--ride", description = "take the ride that is recorded in the scene, instead of a number")
    private boolean ride;

    @Option(
            names = "--duration",
            paramLabel = "S",
            description = "seconds that it plays, from 0.1 to 600; default: 4, or those of the recorded ride")
    private Double seconds;

    @Option(
            names = "--fps",
            defaultValue = "" + Animation.FRAME_RATE,
            paramLabel = "N",
            description = "pictures a second, from 1 to 60; default: ${DEFAULT-VALUE}")
    private long frameRate;

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
        Recording recording = ride ? ofRide(studio) : ofNumber(studio);
        Set<String> warnings = new LinkedHashSet<>(requirePossible(recording.film));
        long start = System.nanoTime();
        PrintWriter err = spec.commandLine().getErr();
        ProgressLine progress = new ProgressLine(err);
        Path place;
        try (AnimationWriter writer = open(recording.film.frameRate())) {
            warnings.addAll(AnimationRecorder.record(
                            recording.film, writer, recording.caption, moment -> PictureDecoration.NONE, progress)
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
                        recording.film.frames()));
        Photographer.tellFilesToKeep(studio, err);
        return 0;
    }

    /** What is photographed, and what is written into it. */
    private record Recording(Film film, Film.Caption caption) {}

    private double duration(double usual) {
        return seconds == null
                ? usual
                : MistakeException.inOption(
                        "--duration", () -> Require.within("duration", seconds, Animation.SHORTEST, Animation.LONGEST));
    }

    private int frameRate() {
        return MistakeException.inOption(
                "--fps", () -> Require.within("fps", frameRate, 1, Animation.HIGHEST_FRAME_RATE));
    }

    private Recording ofRide(Studio studio) {
        ParseResult given = spec.commandLine().getParseResult();
        for (String other : List.of("--number", "--from", "--to", "--back")) {
            if (given.hasMatchedOption(other)) {
                throw new MistakeException(
                        other + ": a ride has no number to animate; leave out this option or --ride");
            }
        }
        if (studio.ride().isEmpty()) {
            throw new MistakeException("--ride: no ride is recorded in " + scene + "; the window records one");
        }
        double recorded = studio.ride().stream().mapToDouble(RideLeg::seconds).sum();
        RideFilm film =
                MistakeException.inOption("--ride", () -> new RideFilm(studio, duration(recorded), frameRate()));
        return new Recording(film, Captions.ofPictures(film, captioned));
    }

    private Recording ofNumber(Studio studio) {
        StudioNumber animated = MistakeException.inOption("--number", () -> StudioNumber.at(number, studio));
        requireEnds();
        Animation animation = new Animation(
                animated,
                from,
                to,
                duration(DEFAULT_SECONDS),
                back ? Animation.Course.THERE_AND_BACK : Animation.Course.FORWARDS,
                frameRate());
        with("--from", from, studio, animated);
        with("--to", to, studio, animated);
        for (int i = 0; i < animation.frames(); i++) {
            with("--number " + number, animation.value(animation.timeOf(i)), studio, animated);
        }
        return new Recording(animation.film(studio), Captions.ofPictures(studio, animated, captioned));
    }

    private void requireEnds() {
        if (from == null || to == null) {
            throw new MistakeException("Missing required " + (from == null && to == null ? "options" : "option") + ": "
                    + Stream.of(from == null ? "--from=A" : "", to == null ? "--to=B" : "")
                            .filter(name -> !name.isEmpty())
                            .collect(Collectors.joining(", "))
                    + "; or --ride for the ride that is recorded in the scene");
        }
    }

    /**
     * Looks for mistakes in all pictures first, so that one in the last picture is not found after an hour of work.
     *
     * @return warnings about the scene at both ends
     */
    private List<String> requirePossible(Film film) {
        Studio first = film.studio(0);
        Studio last = film.studio(film.frames() - 1);
        Photographer.info(first, scene);
        RenderPlan begin = ScenePlan.of(first, scene);
        RenderPlan end = ScenePlan.of(last, begin, scene);
        Photographer.requireMemory(first.settings(), Quality.of(first));
        if (!force) {
            Photographer.requireFree(output);
        }
        return Stream.concat(begin.warnings().stream(), end.warnings().stream()).toList();
    }

    /** The studio with another value, which was given by an option. */
    private static void with(String option, double value, Studio studio, StudioNumber number) {
        try {
            Objects.requireNonNull(number.with(studio, value));
        } catch (InvalidPropertyException refused) {
            throw new MistakeException(option + ": " + refused.getMessage());
        }
    }

    private AnimationWriter open(int rate) {
        try {
            AnimationFormat format =
                    OutputOption.namesFolder(spec) ? AnimationFormat.NUMBERED_PNG : AnimationFormat.of(output);
            return force ? format.open(output, rate) : format.openNew(output, rate);
        } catch (FileException wrongPlace) {
            // not a failure of the disk: the user named the place
            throw new MistakeException(wrongPlace.getMessage());
        }
    }
}
