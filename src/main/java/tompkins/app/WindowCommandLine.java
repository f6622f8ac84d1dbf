package tompkins.app;

import java.net.URISyntaxException;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import tompkins.animation.Animation;
import tompkins.io.Assignment;
import tompkins.io.Differences;
import tompkins.property.NumberText;
import tompkins.studio.FrontWindow;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;
import tompkins.studio.StudioNumber;
import tompkins.ui.exchange.CommandLineWriter;

/**
 * Writes what the window does as a call of {@code render} or {@code animate}: the scene file, and options for what has
 * changed since.
 */
final class WindowCommandLine implements CommandLineWriter {

    /** Nobody copies a longer line. */
    private static final int LONGEST = 4000;

    /** A time of an animation at which its value is neither the first nor the last. */
    private static final double BETWEEN = 0.25;

    private final Path jar;

    /** Writes calls of the program that is running. */
    WindowCommandLine() {
        this(running());
    }

    /** Writes calls of a program: of its jar, or of the one that Maven makes beside the folder of its classes. */
    WindowCommandLine(Path program) {
        jar = Files.isDirectory(program) ? program.resolveSibling("tompkins.jar") : program;
    }

    private static Path running() {
        URL place =
                WindowCommandLine.class.getProtectionDomain().getCodeSource().getLocation();
        try {
            return Path.of(place.toURI());
        } catch (URISyntaxException impossible) {
            throw new IllegalStateException("the program lies in a place without a usable name: " + place, impossible);
        }
    }

    @Override
    public Optional<String> photograph(Studio studio, Studio opened, Path file) {
        return line("render", studio, opened, file);
    }

    @Override
    public Optional<String> animation(Studio studio, Animation animation, boolean captioned, Studio opened, Path file) {
        Studio start = start(studio, animation, opened);
        boolean backwards = animation.course() == Animation.Course.BACKWARDS;
        return line("animate", start, opened, file)
                .map(line ->
                        line + " --number=" + quoted(animation.number().path().toString())
                                + " --from=" + NumberText.of(backwards ? animation.to() : animation.from())
                                + " --to=" + NumberText.of(backwards ? animation.from() : animation.to())
                                + " --duration=" + NumberText.of(animation.seconds())
                                + (animation.course() == Animation.Course.THERE_AND_BACK ? " --back" : "")
                                + (captioned ? " --caption" : "")
                                + " -o animation.png");
    }

    /**
     * The studio with a value of the animated number that needs no option; its present value does not matter. If the
     * speed is animated in another direction than before, the value is a speed of the animation, so that the options
     * contain that direction.
     */
    private static Studio start(Studio studio, Animation animation, Studio opened) {
        StudioNumber number = animation.number();
        if (number.isSpeed()) {
            return studio.velocity().givenDirection().equals(opened.velocity().givenDirection())
                    ? FrontWindow.withVelocity(studio, opened.velocity())
                    : number.with(studio, animation.value(BETWEEN));
        }
        return number.isIn(opened) ? number.with(studio, number.in(opened)) : studio;
    }

    private Optional<String> line(String command, Studio studio, Studio opened, Path file) {
        if (file == null) {
            return Optional.empty();
        }
        Studio meant = sampled(studio, opened);
        Studio fast = FrontWindow.withVelocity(opened, meant.velocity());
        Optional<List<Assignment>> others = Differences.between(fast, meant);
        if (others.isEmpty()) {
            return Optional.empty();
        }
        List<Assignment> assignments = new ArrayList<>();
        Differences.between(opened, opened.withVelocity(meant.velocity())).ifPresent(assignments::addAll);
        assignments.addAll(others.get());
        String line = "java -jar " + quoted(jar) + " " + command + " " + quoted(file) + options(assignments, meant);
        return line.length() <= LONGEST ? Optional.of(line) : Optional.empty();
    }

    /** The studio; if it asks for an error, with the samples of another one, since their number has no meaning then. */
    private static Studio sampled(Studio studio, Studio opened) {
        RenderSettings settings = studio.settings();
        return settings.targetError() > 0
                ? studio.withSettings(
                        settings.withSamples(opened.settings().samples()).withTargetError(settings.targetError()))
                : studio;
    }

    private String options(List<Assignment> assignments, Studio studio) {
        RenderSettings settings = studio.settings();
        Set<String> options = new LinkedHashSet<>();
        for (Assignment assignment : assignments) {
            String value = assignment.value();
            options.add(
                    switch (assignment.path()) {
                        case "velocity.beta" -> "--beta=" + value;
                        case "velocity" ->
                            value.startsWith("[") ? "--beta=" + value.replaceAll("[\\[\\] ]", "") : setting(assignment);
                        case "settings.width", "settings.height" ->
                            "--size " + settings.width() + "x" + settings.height();
                        case "settings.samples", "settings.targetError" ->
                            settings.targetError() > 0
                                    ? "--error=" + NumberText.of(settings.targetError())
                                    : "--samples " + settings.samples();
                        default -> setting(assignment);
                    });
        }
        return options.stream().map(option -> " " + option).collect(Collectors.joining());
    }

    /** A value by the short name of its option, if it has one. */
    private String setting(Assignment assignment) {
        return SceneOptions.PATHS.entrySet().stream()
                .filter(option -> option.getValue().equals(assignment.path()))
                .map(option -> option.getKey() + "=" + assignment.value())
                .findFirst()
                .orElseGet(() -> SetOption.NAME + " " + quoted(assignment.path() + "=" + assignment.value()));
    }

    /** The whole path of a file, for any folder. */
    private String quoted(Path file) {
        return quoted(file.toAbsolutePath().toString());
    }

    /** A text in the form that a shell takes for one word; Windows has other shells, and other letters in paths. */
    private String quoted(String name) {
        boolean windows = jar.getFileSystem().getSeparator().equals("\\");
        if (name.matches(windows ? "[\\p{L}\\p{N}._\\\\:=-]+" : "[\\p{L}\\p{N}._/:=-]+")) {
            return name;
        }
        return windows ? '"' + name.replace("\"", "\\\"") + '"' : "'" + name.replace("'", "'\\''") + "'";
    }
}
