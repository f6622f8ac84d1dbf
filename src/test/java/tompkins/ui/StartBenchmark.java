package tompkins.ui;

import java.awt.AWTException;
import java.awt.Color;
import java.awt.Robot;
import tompkins.app.Main;

/** Starts the program, and ends it as soon as there is a picture on the screen. */
public final class StartBenchmark {

    /** A place on the screen where the picture is, in pixels. */
    private static final int X = 200;

    private static final int Y = 400;

    /** Screen and window are grey where no picture is. */
    private static final int LEAST_DIFFERENCE_OF_A_COLOUR = 50;

    private StartBenchmark() {}

    /** Starts the program with some arguments, from which a window with a colourful picture must open. */
    public static void main(String[] arguments) throws AWTException, InterruptedException {
        Main.main(arguments);
        Robot robot = new Robot();
        while (!isColour(robot.getPixelColor(X, Y))) {
            Thread.sleep(2);
        }
        // no time for farewells
        Runtime.getRuntime().halt(0);
    }

    private static boolean isColour(Color pixel) {
        return Math.abs(pixel.getRed() - pixel.getBlue()) > LEAST_DIFFERENCE_OF_A_COLOUR;
    }
}
