package tompkins.app;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Option;
import tompkins.camera.Camera;
import tompkins.light.ColourLaw;
import tompkins.light.Metering;
import tompkins.property.Descriptions;
import tompkins.property.InvalidPropertyException;
import tompkins.property.NumberText;
import tompkins.property.Require;
import tompkins.shutter.RollingShutter;
import tompkins.shutter.Shutter;
import tompkins.shutter.SweepDirection;
import tompkins.spacetime.MetricSpeed;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;
import tompkins.studio.FrontWindow;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;
import tompkins.studio.View;

/** Options that change a studio before its picture is taken. */
final class StudioOptions {

    @Option(names = "--size", paramLabel = "WxH", description = "size of the picture in pixels, such as 640x480")
    private String size;

    /** What was said about the velocity; one option at most. */
    private static final class Motion {

        @Option(
                names = "--beta",
                paramLabel = "B|X,Y,Z",
                description =
                        "speed of the camera in units of c, or as \"150000 km/s\"; its direction stays, or is z if the scene"
                                + " gives none; or its velocity; a Lorentz window in front of the lens that had the same velocity follows")
        private String beta;

        @Option(
                names = "--gamma",
                paramLabel = "G",
                description = "Lorentz factor of the camera; its direction stays, or is z if the scene gives none")
        private Double gamma;
    }

    @ArgGroup
    private Motion motion = new Motion();

    @Option(
            names = "--shutter",
            paramLabel = "NAME",
            completionCandidates = ShutterNames.class,
            description = "model of the shutter: ${COMPLETION-CANDIDATES}")
    private String shutter;

    @Option(names = "--time", paramLabel = "T", description = "opening time of the shutter")
    private Double time;

    @Option(
            names = "--exposure",
            paramLabel = "T",
            description = "time for which the shutter stays open; the picture is the mean over it")
    private Double exposure;

    @Option(
            names = "--sweep",
            paramLabel = "T",
            description = "time in which a rolling shutter runs from edge to edge; with 0 all lines open together")
    private Double sweep;

    @Option(
            names = "--rolling",
            paramLabel = "DIRECTION",
            completionCandidates = OptionWords.SweepDirections.class,
            description = "the direction in which the shutter rolls: ${COMPLETION-CANDIDATES}")
    private SweepDirection rolling;

    @Option(
            names = "--colours",
            paramLabel = "LAW",
            completionCandidates = OptionWords.ColourLaws.class,
            description = "what the motion does to brightness and colours: ${COMPLETION-CANDIDATES}")
    private ColourLaw colours;

    @Option(
            names = "--metering",
            paramLabel = "WHERE",
            completionCandidates = OptionWords.Meterings.class,
            description = "where light is metered if motion makes it brighter or darker: ${COMPLETION-CANDIDATES}")
    private Metering metering;

    @Option(
            names = "--view",
            paramLabel = "VIEW",
            completionCandidates = OptionWords.Views.class,
            description = "what light brings to the camera, or where things are, which is not a photograph:"
                    + " ${COMPLETION-CANDIDATES}")
    private View view;

    /** The studio with all options that were given. */
    Studio applyTo(Studio studio) {
        Studio changed = studio;
        if (size != null) {
            changed = changed.withSettings(sized(studio.settings()));
        }
        changed = withVelocity(changed);
        if (colours != null) {
            changed = changed.withColours(colours);
        }
        if (metering != null) {
            changed = changed.withMetering(metering);
        }
        if (view != null) {
            changed = changed.withView(view);
        }
        Shutter model = changed.camera().shutter();
        if (shutter != null) {
            model = shutterNamed(shutter, model);
        }
        if (time != null) {
            Shutter closed = model;
            if (!closed.hasOpeningTime()) {
                throw new MistakeException(
                        "--time: the " + ShutterNames.of(closed.getClass()) + " shutter has no opening time");
            }
            model = MistakeException.inOption("--time", () -> closed.openedAt(time));
        }
        return changed.withCamera(timed(changed.camera().withShutter(model)));
    }

    private Camera timed(Camera camera) {
        Camera exposed = exposure == null
                ? camera
                : MistakeException.inOption("--exposure", () -> camera.withExposureTime(exposure));
        RollingShutter present = camera.rollingShutter();
        SweepDirection direction = rolling == null ? present.direction() : rolling;
        RollingShutter wanted = MistakeException.inOption(
                "--sweep", () -> new RollingShutter(direction, sweep == null ? present.sweep() : sweep));
        return exposed.withRollingShutter(wanted);
    }

    private Studio withVelocity(Studio studio) {
        Vector3dc direction = studio.velocity().givenDirection();
        if (motion.beta != null) {
            double[] beta = beta(motion.beta);
            String hint = SpeedScale.roundingHint(Stream.of(motion.beta.split(",")));
            String fasterSpeeds = hint.isEmpty() ? "" : hint + ", or --gamma";
            return MistakeException.inOption(
                    "--beta",
                    fasterSpeeds,
                    () -> FrontWindow.withVelocity(
                            studio,
                            beta.length == 1
                                    ? Velocity.of(SpeedScale.BETA, beta[0], direction)
                                    : Velocity.of(new Vector3d(beta))));
        }
        if (motion.gamma != null) {
            double gamma = MistakeException.inOption(
                    "--gamma", () -> Require.within("gamma", motion.gamma, 1, Velocity.LARGEST_GAMMA));
            return FrontWindow.withVelocity(studio, Velocity.of(SpeedScale.GAMMA, gamma, direction));
        }
        return studio;
    }

    private static double[] beta(String text) {
        try {
            OptionalDouble metric = MetricSpeed.parse(text);
            if (metric.isPresent()) {
                return new double[] {metric.getAsDouble()};
            }
        } catch (NumberFormatException notANumber) {
            // the message below says what is allowed
        }
        return numbers("--beta", text, "0.9", "0,0,0.9");
    }

    private RenderSettings sized(RenderSettings settings) {
        int[] sides = pair(
                size,
                "[xX]",
                "--size must be two whole numbers from 1 to " + RenderSettings.LONGEST_SIDE + " such as 640x480");
        try {
            return settings.withSize(sides[0], sides[1]);
        } catch (InvalidPropertyException side) {
            throw new MistakeException("--size " + size + ": " + side.getMessage());
        }
    }

    /**
     * Two whole numbers.
     *
     * @param separator a regular expression for what is between them
     * @param demand the message if they are not
     */
    static int[] pair(String text, String separator, String demand) {
        String[] parts = text.split(separator, -1);
        try {
            if (parts.length == 2) {
                return new int[] {Integer.parseInt(parts[0].trim()), Integer.parseInt(parts[1].trim())};
            }
        } catch (NumberFormatException notWhole) {
            // the message below says what is allowed
        }
        throw new MistakeException(demand + ", was " + text);
    }

    /** Numbers with commas between them, as many as one of the examples has. */
    static double[] numbers(String option, String text, String... examples) {
        List<Integer> counts =
                Stream.of(examples).map(example -> example.split(",").length).toList();
        String[] parts = text.split(",", -1);
        if (!counts.contains(parts.length) && counts.contains(1)) {
            // such as 0,9
            parts = new String[] {text};
        }
        double[] numbers = new double[parts.length];
        try {
            for (int i = 0; i < parts.length; i++) {
                numbers[i] = NumberText.parse(parts[i].trim());
            }
        } catch (NumberFormatException notANumber) {
            numbers = new double[0];
        }
        if (!counts.contains(numbers.length) || !Arrays.stream(numbers).allMatch(Double::isFinite)) {
            throw new MistakeException(option + " must be " + either(counts.stream())
                    + " numbers with commas between them, such as "
                    + either(Stream.of(examples).map(example -> option + "=" + example)) + ", was " + text);
        }
        return numbers;
    }

    private static String either(Stream<?> choices) {
        return choices.map(Object::toString).collect(Collectors.joining(" or "));
    }

    /** The model with a name such as {@code detector-plane}; the present one stays as it is, with all its values. */
    private static Shutter shutterNamed(String name, Shutter present) {
        for (Class<?> type : Shutter.class.getPermittedSubclasses()) {
            if (plain(type.getSimpleName()).equals(plain(name) + "shutter")
                    || plain(type.getSimpleName()).equals(plain(name))) {
                return type.isInstance(present) ? present : (Shutter) Descriptions.standard(type);
            }
        }
        throw new MistakeException(
                "--shutter must be one of " + String.join(", ", new ShutterNames()) + "; was " + name);
    }

    private static String plain(String name) {
        return name.replaceAll("[-_ ]", "").toLowerCase(Locale.ROOT);
    }
}
