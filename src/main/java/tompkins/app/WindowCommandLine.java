package tompkins.app;

import java.net.URISyntaxException;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.joml.Vector3dc;
import tompkins.animation.Animation;
import tompkins.camera.Camera;
import tompkins.math.Vectors;
import tompkins.property.Descriptions;
import tompkins.property.InvalidPropertyException;
import tompkins.property.NumberText;
import tompkins.shutter.Shutter;
import tompkins.spacetime.Velocity;
import tompkins.studio.FrontWindow;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;
import tompkins.studio.StudioNumber;
import tompkins.ui.CommandLineWriter;

/**
 * Writes what the window does as a call of {@code render} or {@code animate}: the scene file, and options for what has
 * changed since.
 */
final class WindowCommandLine implements CommandLineWriter {

    /** Lorentz factors that differ by less than this share give pictures that look the same. */
    private static final double SAME = 1e-9;

    /** By how much a unit vector may change when it is normalised again. */
    private static final double SAME_DIRECTION = 1e-15;

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
                        line + " --number=" + quoted(animation.number().place().toString())
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
            return hasDirectionOf(opened.velocity(), studio.velocity())
                    ? FrontWindow.withVelocity(studio, opened.velocity())
                    : number.with(studio, animation.value(BETWEEN));
        }
        return number.isIn(opened) ? number.with(studio, number.in(opened)) : studio;
    }

    private Optional<String> line(String command, Studio studio, Studio opened, Path file) {
        Optional<String> velocity = velocity(studio.velocity(), opened.velocity());
        if (file == null || velocity.isEmpty() || !isSayable(studio, opened)) {
            return Optional.empty();
        }
        StringBuilder line = new StringBuilder("java -jar " + quoted(jar) + " " + command + " " + quoted(file));
        RenderSettings settings = studio.settings();
        RenderSettings before = opened.settings();
        if (settings.width() != before.width() || settings.height() != before.height()) {
            line.append(" --size ").append(settings.width()).append('x').append(settings.height());
        }
        appendSamples(line, settings, before);
        if (settings.seed() != before.seed()) {
            line.append(" --seed ").append(settings.seed());
        }
        line.append(velocity.get());
        if (studio.colours() != opened.colours()) {
            line.append(" --colours ").append(OptionWords.of(studio.colours()));
        }
        if (studio.metering() != opened.metering()) {
            line.append(" --metering ").append(OptionWords.of(studio.metering()));
        }
        if (studio.view() != opened.view()) {
            line.append(" --view ").append(OptionWords.of(studio.view()));
        }
        if (settings.toneCurve() != before.toneCurve()) {
            line.append(" --tone ").append(OptionWords.of(settings.toneCurve()));
        }
        appendShutter(line, studio.camera().shutter(), opened.camera().shutter());
        appendTiming(line, studio.camera(), opened.camera());
        return Optional.of(line.toString());
    }

    /** The options for a velocity, no letters if it has not changed; empty if no option can express it. */
    private static Optional<String> velocity(Velocity now, Velocity before) {
        if (now.equals(before)) {
            return Optional.of("");
        }
        if (hasSayableComponents(now)) {
            Vector3dc beta = now.components();
            return Optional.of(" --beta=" + NumberText.of(beta.x()) + "," + NumberText.of(beta.y()) + ","
                    + NumberText.of(beta.z()));
        }
        return hasDirectionOf(before, now) ? Optional.of(" --gamma=" + NumberText.of(now.gamma())) : Optional.empty();
    }

    private static boolean hasDirectionOf(Velocity before, Velocity now) {
        return Vectors.unit(now.givenDirection()).equals(Vectors.unit(before.givenDirection()), SAME_DIRECTION);
    }

    private static void appendSamples(StringBuilder line, RenderSettings now, RenderSettings before) {
        if (now.targetError() > 0) {
            if (now.targetError() != before.targetError()) {
                line.append(" --error=").append(NumberText.of(now.targetError()));
            }
        } else if (now.samples() != before.samples() || before.targetError() > 0) {
            line.append(" --samples ").append(now.samples());
        }
    }

    private static void appendShutter(StringBuilder line, Shutter now, Shutter before) {
        if (now.getClass() != before.getClass()) {
            line.append(" --shutter ").append(ShutterNames.of(now.getClass()));
        }
        if (!now.equals(withoutTime(now, before))) {
            line.append(" --time=").append(NumberText.of(now.openingTime()));
        }
    }

    private static void appendTiming(StringBuilder line, Camera now, Camera before) {
        if (now.exposureTime() != before.exposureTime()) {
            line.append(" --exposure=").append(NumberText.of(now.exposureTime()));
        }
        if (now.rollingShutter().sweep() != before.rollingShutter().sweep()) {
            line.append(" --sweep=").append(NumberText.of(now.rollingShutter().sweep()));
        }
        if (now.rollingShutter().direction() != before.rollingShutter().direction()) {
            line.append(" --rolling ")
                    .append(OptionWords.of(now.rollingShutter().direction()));
        }
    }

    /** The shutter that the command has before it reads an opening time. */
    private static Shutter withoutTime(Shutter now, Shutter before) {
        return now.getClass() == before.getClass() ? before : (Shutter) Descriptions.standard(now.getClass());
    }

    /** Whether the options can express everything that has changed besides the velocity. */
    private static boolean isSayable(Studio studio, Studio opened) {
        Shutter now = studio.camera().shutter();
        Shutter start = withoutTime(now, opened.camera().shutter());
        RenderSettings settings = studio.settings();
        Studio said = FrontWindow.withVelocity(opened, studio.velocity())
                .withColours(studio.colours())
                .withMetering(studio.metering())
                .withView(studio.view())
                .withCamera(opened.camera()
                        .withShutter(start.openedAt(now.openingTime()))
                        .withExposureTime(studio.camera().exposureTime())
                        .withRollingShutter(studio.camera().rollingShutter()))
                .withSettings(opened.settings()
                        .withSize(settings.width(), settings.height())
                        .withSamples(settings.samples())
                        .withTargetError(settings.targetError())
                        .withSeed(settings.seed())
                        .withToneCurve(settings.toneCurve()));
        return said.equals(studio);
    }

    /**
     * Whether the components of the velocity give its speed: near the speed of light they do not have enough digits.
     */
    private static boolean hasSayableComponents(Velocity velocity) {
        try {
            double gamma = Velocity.of(velocity.components()).gamma();
            return Math.abs(gamma - velocity.gamma()) <= SAME * velocity.gamma();
        } catch (InvalidPropertyException roundedToLight) {
            return false;
        }
    }

    /** The whole path of a file, for any folder. */
    private String quoted(Path file) {
        return quoted(file.toAbsolutePath().toString());
    }

    /** A text in the form that a shell takes for one word; Windows has other shells, and other letters in paths. */
    private String quoted(String name) {
        boolean windows = jar.getFileSystem().getSeparator().equals("\\");
        if (name.matches(windows ? "[\\p{L}\\p{N}._\\\\:-]+" : "[\\p{L}\\p{N}._/:-]+")) {
            return name;
        }
        return windows ? '"' + name + '"' : "'" + name.replace("'", "'\\''") + "'";
    }
}
