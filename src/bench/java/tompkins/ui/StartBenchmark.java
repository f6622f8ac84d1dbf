package tompkins.ui;

import java.awt.AWTException;
import java.awt.Color;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.image.BufferedImage;
import java.util.stream.IntStream;
import tompkins.app.Main;

/** Starts the program, and ends it as soon as there is a picture on the screen. */
public final class StartBenchmark {

    /** Pixels of the screen, beside each other, where the picture is and no text over it. */
    private static final Rectangle PLACE = new Rectangle(20, 400, 300, 1);

    /** Screen and window are grey where no picture is. */
    private static final int LEAST_DIFFERENCE_OF_A_COLOUR = 50;

    private StartBenchmark() {}

    /** Starts the program with some arguments, from which a window with a colourful picture must open. */
    public static void main(String[] arguments) throws AWTException, InterruptedException {
        Main.main(arguments);
        Robot robot = new Robot();
        while (!isColourful(robot.createScreenCapture(PLACE))) {
            Thread.sleep(2);
        }
        // no time for farewells
        Runtime.getRuntime().halt(0);
    }

    private static boolean isColourful(BufferedImage pixels) {
        return IntStream.range(0, pixels.getWidth())
                .mapToObj(x -> new Color(pixels.getRGB(x, 0)))
                .anyMatch(pixel -> Math.abs(pixel.getRed() - pixel.getBlue()) > LEAST_DIFFERENCE_OF_A_COLOUR);
    }
}
