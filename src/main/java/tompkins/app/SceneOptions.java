package tompkins.app;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Option;
import tompkins.io.Assignment;
import tompkins.property.MistakeException;
import tompkins.property.NumberText;
import tompkins.spacetime.MetricSpeed;

/** Options that give other values to a scene: any by its path, a few by a short name. */
class SceneOptions extends SetOption {

    /** The paths of the options that take a value alone. */
    static final Map<String, String> PATHS = Map.of(
            "--gamma", "velocity.gamma",
            "--time", "camera.shutter.openingTime",
            "--exposure", "camera.exposureTime",
            "--colours", "colours",
            "--seed", "settings.seed");

    @Option(names = "--size", paramLabel = "WxH", description = "size of the picture in pixels, such as 640x480")
    private String size;

    /** What was said about the velocity; one option at most. */
    private static final class Motion {

        @Option(
                names = "--beta",
                paramLabel = "B|X,Y,Z",
                description = "speed of the camera in units of c, or as \"150000 km/s\", in the same direction;"
                        + " or its velocity. A window that has it, in front of the lens, follows")
        private String beta;

        @Option(
                names = "--gamma",
                paramLabel = "G",
                description = "Lorentz factor of the camera, in the same direction")
        private String gamma;
    }

    @ArgGroup
    private Motion motion = new Motion();

    @Option(names = "--time", paramLabel = "T", description = "opening time of the shutter")
    private String time;

    @Option(
            names = "--exposure",
            paramLabel = "T",
            description = "time for which the shutter stays open; the picture is the mean over it")
    private String exposure;

    @Option(
            names = "--colours",
            paramLabel = "LAW",
            description = "what motion does to brightness and colours: unchanged, searchlight or doppler")
    private String colours;

    @Override
    List<Assignment> assignments() {
        List<Assignment> all = new ArrayList<>(super.assignments());
        if (size != null) {
            String[] sides = size.split("[xX]", -1);
            if (sides.length != 2) {
                throw new MistakeException(
                        "--size must be two whole numbers such as 640x480, was " + OptionValues.shown(size));
            }
            all.add(new Assignment("--size", "settings.width", sides[0]));
            all.add(new Assignment("--size", "settings.height", sides[1]));
        }
        if (motion.beta != null) {
            all.add(ofBeta(motion.beta));
        }
        add("--gamma", motion.gamma, all);
        add("--time", time, all);
        add("--exposure", exposure, all);
        add("--colours", colours, all);
        return all;
    }

    /** Adds the value of an option, if it was given. */
    static void add(String option, String value, List<Assignment> all) {
        if (value != null) {
            all.add(new Assignment(option, PATHS.get(option), value));
        }
    }

    private static Assignment ofBeta(String beta) {
        try {
            OptionalDouble metric = MetricSpeed.parse(beta);
            if (metric.isPresent()) {
                return new Assignment("--beta", "velocity.beta", NumberText.of(metric.getAsDouble()));
            }
        } catch (NumberFormatException noNumber) {
            // refused below, as any other word
        }
        boolean isSpeed = NumberText.withPoint(beta).indexOf(',') < 0;
        return new Assignment("--beta", isSpeed ? "velocity.beta" : "velocity", beta);
    }
}
