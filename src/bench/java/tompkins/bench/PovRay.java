package tompkins.bench;

import java.awt.image.Raster;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;

/**
 * Renders the paper's scene with POV-Ray 3.7, if it is installed, with one thread, and reads the time of the processor
 * from what it prints.
 */
final class PovRay {

    private static final Path SCENE = Path.of("src/bench/povray/figure.pov");
    private static final Path PICTURE = Path.of("target/povray.png");
    private static final Pattern TIME =
            Pattern.compile("Trace Time:[^)]*\\)\\s*using 1 thread\\(s\\) with ([0-9.]+) CPU-seconds");
    private static final Pattern VERSION = Pattern.compile("POV-Ray ([0-9.]*[0-9])");

    /** Why nothing can be compared. */
    static final String MISSING = "POV-Ray is not installed (apt-get install povray)";

    private PovRay() {}

    /**
     * A picture.
     *
     * @param seconds of the processor that tracing took
     * @param light three channels of each pixel, linear; white is 1
     */
    record Taken(double seconds, double[] light) {}

    /** The version; null if there is no POV-Ray here. */
    static String version() throws InterruptedException {
        try {
            Matcher version = VERSION.matcher(run("povray", "--version"));
            return version.find() ? version.group(1) : null;
        } catch (IOException notInstalled) {
            return null;
        }
    }

    /**
     * Takes Fig. 1(a).
     *
     * @param antialiasing its options for that
     */
    static Taken take(int width, int height, String... antialiasing) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of(
                "povray",
                "+I" + SCENE,
                "+W" + width,
                "+H" + height,
                "-D",
                "+WT1",
                "+BM2",
                "+FN16",
                "File_Gamma=1.0",
                "+O" + PICTURE));
        command.addAll(List.of(antialiasing));
        String printed = run(command.toArray(String[]::new));
        Matcher time = TIME.matcher(printed);
        if (!time.find()) {
            throw new IOException("POV-Ray printed no time: " + printed);
        }
        Raster raster = ImageIO.read(PICTURE.toFile()).getRaster();
        double[] light = raster.getPixels(0, 0, width, height, (double[]) null);
        for (int i = 0; i < light.length; i++) {
            light[i] /= 65535;
        }
        Files.delete(PICTURE);
        return new Taken(Double.parseDouble(time.group(1)), light);
    }

    private static String run(String... command) throws IOException, InterruptedException {
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        String printed = new String(process.getInputStream().readAllBytes(), StandardCharsets.ISO_8859_1);
        process.waitFor();
        return printed;
    }
}
