package tompkins.bench;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Renders the paper's scene with POV-Ray 3.7, if it is installed, and reads the time of tracing from what it prints.
 */
final class PovRay {

    private static final Path SCENE = Path.of("src/bench/povray/figure.pov");
    private static final Pattern TIME = Pattern.compile("Trace Time:.*\\(([0-9.]+) seconds\\)");

    /** Why nothing can be compared. */
    static final String MISSING = "POV-Ray is not installed (apt-get install povray)";

    private PovRay() {}

    /** The time of tracing a picture in milliseconds; NaN if there is no POV-Ray here. */
    static double milliseconds(boolean moving, int width, int height, int threads) throws InterruptedException {
        try {
            Process process = new ProcessBuilder(
                            "povray",
                            "+I" + SCENE,
                            "Declare=Moving=" + (moving ? 1 : 0),
                            "+W" + width,
                            "+H" + height,
                            "-D",
                            "-A",
                            "+WT" + threads,
                            "+BM2",
                            "-F")
                    .redirectErrorStream(true)
                    .start();
            String printed = new String(process.getInputStream().readAllBytes(), StandardCharsets.ISO_8859_1);
            process.waitFor();
            Matcher time = TIME.matcher(printed);
            return time.find() ? 1000 * Double.parseDouble(time.group(1)) : Double.NaN;
        } catch (IOException notInstalled) {
            return Double.NaN;
        }
    }
}
