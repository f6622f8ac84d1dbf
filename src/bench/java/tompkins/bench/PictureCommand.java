package tompkins.bench;

import java.awt.image.Raster;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;

/**
 * A command that takes a picture of 16 bits in a new process. Linux tells what it used of the processor.
 *
 * @param setting what is special about it, for people
 * @param command the program and its arguments
 * @param rendering finds, as its first group, the seconds of rendering alone in what the program prints
 * @param file what it writes
 * @param times how many times as wide and as high that is as the picture, whose pixels are its means
 * @param white the share of the largest number that stands for white
 */
record PictureCommand(String setting, List<String> command, Pattern rendering, Path file, int times, double white) {

    private static final Path OWN_PROCESS = Path.of("/proc/self/stat");

    /** Behind its name, the places of the times that ended children of this process took, as user and as system. */
    private static final int USER = 13;

    private static final int SYSTEM = 14;
    private static final double TICKS_IN_A_SECOND = 100;

    private static final double LARGEST = 65535;

    /**
     * Seconds that a picture took.
     *
     * @param processor of all threads of the command
     * @param wall from its start to its end
     * @param rendering for the picture alone, as the program prints it
     */
    record Cost(double processor, double wall, double rendering) {}

    /**
     * Takes the picture.
     *
     * @throws IOException if the command cannot be started, or ends with an error
     */
    Cost run() throws IOException, InterruptedException {
        double before = processorSecondsOfChildren();
        long start = System.nanoTime();
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        String printed = new String(process.getInputStream().readAllBytes(), StandardCharsets.ISO_8859_1);
        int exit = process.waitFor();
        double wall = (System.nanoTime() - start) / 1e9;
        Matcher seconds = rendering.matcher(printed);
        if (exit != 0 || !seconds.find()) {
            throw new IOException("exit code " + exit + " of " + String.join(" ", command) + ": " + printed);
        }
        return new Cost(processorSecondsOfChildren() - before, wall, Double.parseDouble(seconds.group(1)));
    }

    private static double processorSecondsOfChildren() throws IOException {
        String line = Files.readString(OWN_PROCESS);
        String[] numbers = line.substring(line.lastIndexOf(')') + 2).split(" ");
        return (Double.parseDouble(numbers[USER]) + Double.parseDouble(numbers[SYSTEM])) / TICKS_IN_A_SECOND;
    }

    /** The picture that was taken last: three channels of each pixel, linear, 1 for white and all that is brighter. */
    double[] light() throws IOException {
        Raster raster = ImageIO.read(file.toFile()).getRaster();
        int width = raster.getWidth() / times;
        double[] light = new double[3 * width * (raster.getHeight() / times)];
        double[] row = new double[3 * raster.getWidth()];
        for (int y = 0; y < raster.getHeight(); y++) {
            raster.getPixels(0, y, raster.getWidth(), 1, row);
            for (int i = 0; i < row.length; i++) {
                light[3 * (y / times * width + i / 3 / times) + i % 3] += row[i];
            }
        }
        for (int i = 0; i < light.length; i++) {
            light[i] = Math.min(1, light[i] / (LARGEST * white * times * times));
        }
        return light;
    }
}
