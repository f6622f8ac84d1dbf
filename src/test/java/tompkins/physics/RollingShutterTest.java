package tompkins.physics;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.camera.Camera;
import tompkins.property.Descriptions;
import tompkins.sceneobject.Parallelogram;
import tompkins.sceneobject.SceneObject;
import tompkins.shutter.RollingShutter;
import tompkins.shutter.SweepDirection;
import tompkins.spacetime.Velocity;

/** Upright edges that a rolling shutter passes, against the closed form of where their light comes from. */
class RollingShutterTest {

    private static final int WIDTH = 160;
    private static final int HEIGHT = 120;
    private static final double HALF_WIDTH = Math.tan(Math.toRadians(20));
    private static final double PER_PIXEL = 2 * HALF_WIDTH / WIDTH;
    private static final double DEPTH = 10;

    /** An edge at rest in the scene at a place x0 of the camera frame at time 0, with a bright sheet to its left. */
    private static Photograph edge(double speed, double x0, double openingTime, RollingShutter rolling) {
        double gamma = 1 / Math.sqrt(1 - speed * speed);
        SceneObject sheet = new Parallelogram(
                "sheet",
                new Vector3d(gamma * x0, -1e4, DEPTH),
                new Vector3d(-1e4, 0, 0),
                new Vector3d(0, 2e4, 0),
                Photograph.WHITE);
        Camera camera = Descriptions.with(
                Photograph.pinhole(new Vector3d(0, 0, 1), 40, openingTime), "rollingShutter", rolling);
        return Photograph.of(List.of(sheet), camera, Velocity.of(speed, 0, 0), WIDTH, HEIGHT);
    }

    /** Whether light of a direction (x, y, 1) comes from the left of the edge, for a shutter that opens at a time. */
    private static boolean isLeft(double x, double y, double speed, double x0, double time) {
        double emission = time - DEPTH * Math.sqrt(1 + x * x + y * y);
        return x * DEPTH < x0 - speed * emission;
    }

    /** Every pixel by its own line, from an edge that leans to one that is bent by the delay of light. */
    @ParameterizedTest
    @CsvSource({"0.1, DOWN, 8", "0.5, UP, 3", "0.5, RIGHT, 5", "0.8, LEFT, 2", "0.95, DOWN, 1", "0.9, DOWN, 0"})
    void everyPixelSeesTheTimeOfItsLine(double speed, SweepDirection direction, double sweep) {
        double opening = 10.3 - sweep / 2;
        Photograph photograph = edge(speed, 0.1, opening, new RollingShutter(direction, sweep));
        int lit = 0;
        int wrong = 0;
        for (int row = 0; row < HEIGHT; row++) {
            for (int column = 0; column < WIDTH; column++) {
                double line = switch (direction) {
                    case DOWN -> (row + 0.5) / HEIGHT;
                    case UP -> (HEIGHT - row - 0.5) / HEIGHT;
                    case RIGHT -> (column + 0.5) / WIDTH;
                    case LEFT -> (WIDTH - column - 0.5) / WIDTH;
                };
                double x = (column + 0.5 - WIDTH / 2.0) * PER_PIXEL;
                double y = (HEIGHT / 2.0 - row - 0.5) * PER_PIXEL;
                boolean expected = isLeft(x, y, speed, 0.1, opening + sweep * line);
                lit += expected ? 1 : 0;
                wrong += photograph.isLit(column, row, 0) == expected ? 0 : 1;
            }
        }
        assertThat(lit).isBetween(WIDTH * HEIGHT / 4, WIDTH * HEIGHT * 3 / 4);
        assertThat(wrong).as("pixels").isZero();
    }
}
