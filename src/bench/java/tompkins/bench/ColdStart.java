package tompkins.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;

/** Takes a picture with a fresh process, from the start of Java to the file. */
final class ColdStart {

    private static final Path JAR = Path.of("target/tompkins.jar");

    private ColdStart() {}

    /** The median time of some starts in milliseconds; NaN if the jar was not built. */
    static double milliseconds(int starts) throws IOException, InterruptedException {
        if (!Files.exists(JAR)) {
            return Double.NaN;
        }
        Path picture = Files.createTempFile("cold", ".png");
        double[] times = new double[starts];
        for (int i = 0; i < starts; i++) {
            long start = System.nanoTime();
            int exit = new ProcessBuilder(
                            Path.of(System.getProperty("java.home"), "bin", "java")
                                    .toString(),
                            "-jar",
                            JAR.toString(),
                            "render",
                            "scenes/fig1b.json",
                            "--samples",
                            "1",
                            "--force",
                            "-o",
                            picture.toString())
                    .redirectErrorStream(true)
                    .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                    .start()
                    .waitFor();
            times[i] = (System.nanoTime() - start) / 1e6;
            if (exit != 0) {
                throw new IOException("the program ended with exit code " + exit);
            }
        }
        Files.delete(picture);
        Arrays.sort(times);
        return times[starts / 2];
    }
}
