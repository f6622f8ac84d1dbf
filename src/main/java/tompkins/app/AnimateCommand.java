package tompkins.app;

import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParseResult;
import tompkins.animation.Animation;
import tompkins.animation.AnimationRecorder;
import tompkins.animation.FilmAssembly;
import tompkins.animation.FrameSequence;
import tompkins.animation.RideFilm;
import tompkins.explain.Explanation;
import tompkins.image.AnimationFormat;
import tompkins.image.AnimationWriter;
import tompkins.image.Fonts;
import tompkins.image.FrameFolder;
import tompkins.io.Assignment;
import tompkins.property.InvalidPropertyException;
import tompkins.property.MistakeException;
import tompkins.property.Require;
import tompkins.render.Quality;
import tompkins.render.Renderer;
import tompkins.studio.RideLeg;
import tompkins.studio.Studio;
import tompkins.studio.StudioNumber;
import tompkins.studio.StudioPath;
import tompkins.trace.RenderPlan;
import tompkins.ui.photograph.Captions;

/** Saves animations of a number of a scene. */
@Command(
        header = "Takes a film while a number of the scene runs, or of a ride.",
        description =
                "Takes photographs while a number of the scene, such as the speed of the camera, runs from one value"
                        + " to another, or along a recorded ride, and saves them as an animation.")
final class AnimateCommand extends ProgramCommand {

    /** How long it plays unless an option says otherwise. */
    private static final double DEFAULT_SECONDS = 4;

    /** The options that may come with {@code --assemble}. */
    private static final Set<String> OF_ASSEMBLY = Set.of("--assemble", "--output", "--fps", "--force");

    @Parameters(
            arity = "0..1",
            paramLabel = "SCENE",
            description = "scene file, or saved photograph; none with --assemble")
    private Path scene;

    @Option(
            names = {"-o", "--output"},
            paramLabel = "FILE",
            description = "the animation: .gif (256 colours) or .mp4 (if ffmpeg is installed); a name"
                    + " without an ending is a folder of PNG pictures")
    private Path output;

    @Option(
            names = "--number",
            defaultValue = "velocity.beta",
            paramLabel = "PATH",
            description =
                    "path of the number in the scene file, such as velocity.rapidity, camera.shutter.openingTime or"
                            + " scene[0].centre.x; default: ${DEFAULT-VALUE}, the speed")
    private String number;

    @Option(names = "--from", paramLabel = "A", description = "value at the beginning")
    private Double from;

    @Option(
            names = "--to",
            paramLabel = "B",
            description = "value at the end, or in the middle of an animation there and back")
    private Double to;

    @Mixin
    private ThreadsOption threads;

    @Mixin
    private RideOption ride;

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

    @Mixin
    private ManyPictures frames;

    @Option(
            names = "--assemble",
            paramLabel = "FOLDER",
            description = "make the animation of the frames in a folder, or print which are missing (exit code 3)")
    private Path assembled;

    @ArgGroup
    private QualityOptions.Wish quality = new QualityOptions.Wish();

    @Mixin
    private SampledOptions options;

    @Override
    public Integer call() throws Exception {
        requireWhatIsNeeded();
        if (assembled != null) {
            return assemble();
        }
        Studio studio = options.read(scene, quality.assignments());
        Recording recording = ride.isGiven() ? ofRide(ride.start(studio, scene)) : ofNumber(studio);
        if (captioned) {
            Fonts.require();
        }
        AnimationRecorder recorder =
                new AnimationRecorder(recording.film, recording.caption, moment -> picture -> {}, threads.number());
        Set<String> warnings = new LinkedHashSet<>(requirePossible(recording.film));
        if (format() == AnimationFormat.NUMBERED_PNG) {
            OutputOption.inFolder(output, () -> takeFrames(recorder, warnings));
        } else {
            requireWhole();
            takeFilm(recorder, warnings);
        }
        Photographer.tellFilesToKeep(studio, err());
        return 0;
    }

    private void requireWhatIsNeeded() {
        scene = ride.scene(scene);
        if (assembled != null) {
            requireOnlyAssembly();
        } else if (scene == null) {
            throw needed("SCENE: scene file, or saved photograph");
        }
        if (output == null) {
            throw needed("--output=FILE: the animation, or a folder for its frames");
        }
    }

    /** What the library says of other commands; here it depends on other options what is needed. */
    private static MistakeException needed(String what) {
        return new MistakeException("tompkins animate: needs " + what);
    }

    private void requireOnlyAssembly() {
        Optional<String> other = scene != null
                ? Optional.of(scene.toString())
                : commandLine().getParseResult().matchedOptions().stream()
                        .map(OptionSpec::longestName)
                        .filter(name -> !OF_ASSEMBLY.contains(name))
                        .findFirst();
        if (other.isPresent()) {
            throw new MistakeException("--assemble takes frames as they are; leave out " + other.get());
        }
    }

    private void takeFilm(AnimationRecorder recorder, Set<String> warnings) throws Exception {
        FrameSequence film = recorder.film();
        requireFree(NamedFile.ofScene(film.studio(0), scene));
        report(film.frames() + " pictures", warnings, progress -> {
            try (AnimationWriter writer = open(film.frameRate())) {
                warnings.addAll(recorder.record(writer, progress));
                return writer.finish();
            }
        });
    }

    /** Takes all or some frames into a folder, to which other processes may add. */
    private int takeFrames(AnimationRecorder recorder, Set<String> warnings) throws Exception {
        FrameFolder folder = new FrameFolder(output);
        List<Integer> left = left(recorder, folder);
        Studio studio = recorder.film().studio(0);
        left.forEach(frame -> NamedFile.requireNotRead(folder.file(frame), NamedFile.ofScene(studio, scene)));
        if (!left.isEmpty()) {
            Photographer.requireWritable(folder.file(left.get(0)));
        }
        report(left.size() + " of " + recorder.film().frames() + " pictures", warnings, progress -> {
            warnings.addAll(recorder.record(left, folder, frames.skips(), progress));
            return output;
        });
        return 0;
    }

    /** The frames that are still to be taken; refuses what is in their place, unless it is replaced. */
    private List<Integer> left(AnimationRecorder recorder, FrameFolder folder) {
        List<Integer> left = new ArrayList<>();
        for (int frame : frames.own(recorder.allFrames())) {
            AnimationRecorder.Found found = recorder.found(folder, frame);
            boolean isDone = found == AnimationRecorder.Found.SAME && frames.skips();
            if (!isDone && found != AnimationRecorder.Found.NOTHING && !frames.force()) {
                throw new MistakeException(folder.file(frame)
                        + (frames.skips()
                                ? ": is not this frame with these settings; --force replaces it"
                                : ": there is a file of this name already; --force replaces it, --skip-existing leaves"
                                        + " it if it is the same frame"));
            }
            if (!isDone) {
                left.add(frame);
            }
        }
        return left;
    }

    private int assemble() throws Exception {
        FilmAssembly film = NamedFile.used(() -> new FilmAssembly(new FrameFolder(assembled)));
        if (!film.missing().isEmpty()) {
            err().println(assembled + ": of the frames 0-" + (film.count() - 1) + " some are missing or damaged;"
                    + " animate SCENE --skip-existing takes these:");
            out().println(film.missing());
            return Failures.INCOMPLETE;
        }
        requireFree(IntStream.range(0, film.count()).mapToObj(new FrameFolder(assembled)::file));
        if (format() == AnimationFormat.NUMBERED_PNG) {
            throw new MistakeException(output + ": --assemble makes a .gif or .mp4 of the frames; give -o such a name");
        }
        boolean isRateGiven = commandLine().getParseResult().hasMatchedOption("--fps");
        int rate = isRateGiven ? frameRate() : film.frameRate().orElse(Animation.FRAME_RATE);
        report(film.count() + " pictures", Set.of(), progress -> {
            try (AnimationWriter writer = open(rate)) {
                film.write(writer, progress);
                return writer.finish();
            }
        });
        return 0;
    }

    private void requireFree(Stream<Path> read) {
        NamedFile.requireNotRead(output, read);
        if (!frames.force()) {
            Photographer.requireFree(output);
        }
    }

    /** Work that takes a while, and makes a file or a folder. */
    private interface Work {

        Path make(ProgressLine progress) throws Exception;
    }

    /** Works, and says where the result lies. */
    private void report(String made, Set<String> warnings, Work work) throws Exception {
        long start = System.nanoTime();
        ProgressLine progress = new ProgressLine(err());
        Path place;
        try {
            place = work.make(progress);
        } finally {
            progress.clear();
        }
        warnings.forEach(warning -> err().println("warning: " + warning));
        double seconds = (System.nanoTime() - start) / 1e9;
        Path real = place.toRealPath(LinkOption.NOFOLLOW_LINKS);
        out().println(String.format(Locale.ROOT, "%s  (%.2f s, %s)", real, seconds, made));
    }

    /** What is photographed, and what is written into it. */
    private record Recording(FrameSequence film, FrameSequence.Caption caption) {}

    private double duration(double usual) {
        return seconds == null
                ? usual
                : MistakeException.inOption(
                        "--duration", () -> Require.within("duration", seconds, Animation.SHORTEST, Animation.LONGEST));
    }

    private int frameRate() {
        return MistakeException.inOption("--fps", () -> Require.within("fps", frameRate, 1, AnimationFormat.FASTEST));
    }

    private Recording ofRide(Studio studio) {
        ParseResult given = commandLine().getParseResult();
        for (String other : List.of("--number", "--from", "--to", "--back")) {
            if (given.hasMatchedOption(other)) {
                throw new MistakeException(
                        other + ": a ride has no number to animate; leave out this option or --ride");
            }
        }
        double recorded = studio.ride().stream().mapToDouble(RideLeg::seconds).sum();
        RideFilm film =
                MistakeException.inOption("--ride", () -> new RideFilm(studio, duration(recorded), frameRate()));
        return new Recording(film, Captions.ofPictures(film, captioned));
    }

    private Recording ofNumber(Studio studio) {
        StudioNumber animated = MistakeException.inOption("--number", () -> StudioNumber.at(number, studio));
        requireEnds();
        requireNotFixed(animated);
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
        return new Recording(animation.sequence(studio), Captions.ofPictures(studio, animated, captioned));
    }

    /** Refuses an option that gives the number one value; the speed that runs keeps the direction of {@code --beta}. */
    private void requireNotFixed(StudioNumber animated) {
        StudioPath path = animated.path();
        for (Assignment option : options.assignments()) {
            StudioPath fixed = StudioPath.parse(option.path()).orElse(StudioPath.ROOT);
            boolean isSpeed = animated.isSpeed()
                    && fixed.parent().equals(path.parent())
                    && !fixed.last().equals("direction");
            if (isSpeed || fixed.equals(path)) {
                throw new MistakeException(option.option() + ": " + path
                        + " runs from the value of --from to that of --to; leave this option out");
            }
        }
    }

    private void requireEnds() {
        if (from == null || to == null) {
            throw needed(Stream.of(from == null ? "--from=A" : "", to == null ? "--to=B" : "")
                            .filter(name -> !name.isEmpty())
                            .collect(Collectors.joining(" and "))
                    + "; or --ride for the ride that is recorded in the scene");
        }
    }

    /**
     * Looks for mistakes in all pictures first, so that one in the last picture is not found after an hour of work.
     *
     * @return warnings about the scene at both ends
     */
    private List<String> requirePossible(FrameSequence film) {
        Studio first = film.studio(0);
        Studio last = film.studio(film.frames() - 1);
        Photographer.info(first, scene);
        RenderPlan begin = ScenePlan.of(first, scene);
        RenderPlan end = ScenePlan.of(last, begin, scene);
        Renderer.requireMemory(first.settings(), Quality.of(first));
        return Stream.of(begin, end)
                .flatMap(plan -> new Explanation(plan).warnings().stream())
                .toList();
    }

    /** The studio with another value, which was given by an option. */
    private static void with(String option, double value, Studio studio, StudioNumber number) {
        try {
            Objects.requireNonNull(number.with(studio, value));
        } catch (InvalidPropertyException refused) {
            throw new MistakeException(option + ": " + refused.getMessage());
        }
    }

    private void requireWhole() {
        if (frames.hasPart() || frames.skips()) {
            throw new MistakeException("--part and --skip-existing take frames into a folder: give -o a name"
                    + " without an ending, was " + output + "; --assemble makes the film of them");
        }
    }

    private AnimationFormat format() {
        return OutputOption.namesFolder(commandLine())
                ? AnimationFormat.NUMBERED_PNG
                : NamedFile.used(() -> AnimationFormat.of(output));
    }

    private AnimationWriter open(int rate) {
        return NamedFile.used(() -> format().open(output, rate, frames.force()));
    }
}
