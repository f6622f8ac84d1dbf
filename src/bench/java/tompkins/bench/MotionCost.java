package tompkins.bench;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import tompkins.sceneobject.Box;
import tompkins.sceneobject.Group;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.spacetime.Velocity;
import tompkins.studio.PaperStudios;
import tompkins.studio.Studio;
import tompkins.surface.Refractive;
import tompkins.surface.Tiling;
import tompkins.trace.RenderPlan;

/**
 * What it costs that objects move: a thousand dice at rest, with one velocity, and with ten. Where a lamp lights them,
 * it rests in the scene: what it sees of dice at rest is prepared once, and of those that move for each piece of its
 * way past them.
 */
final class MotionCost {

    private static final double SECONDS = 2;
    private static final int DICE = 1000;
    private static final double EDGE = 0.1;
    private static final double SPEED = 0.5;

    /** When the light arrives that left the middle of the dice at time 0. */
    private static final double OPENING_TIME = 10;

    private static final String GLASS = "GLASS";

    /** How the dice move. */
    private enum Motion {
        REST(0),
        ONE_VELOCITY(1),
        TEN_VELOCITIES(10);

        private final int velocities;

        Motion(int velocities) {
            this.velocities = velocities;
        }
    }

    private MotionCost() {}

    /** Measures one scene in this process, and prints the nanoseconds per ray. */
    public static void main(String[] arguments) throws InterruptedException {
        if (arguments[0].equals(GLASS)) {
            System.out.println(
                    OwnProcess.nanosecondsPerRay(RenderPlan.of(glass(Double.parseDouble(arguments[1]))), SECONDS));
            return;
        }
        Studio studio = studio(Motion.valueOf(arguments[0]));
        System.out.println(OwnProcess.nanosecondsPerRay(RenderPlan.of(studio), SECONDS));
    }

    /** Measures all in turns. */
    static void measure(int rounds, List<Measure> measures) throws IOException, InterruptedException {
        double[][] times = new double[Motion.values().length][rounds];
        for (int round = 0; round < rounds; round++) {
            for (Motion motion : Motion.values()) {
                times[motion.ordinal()][round] = OwnProcess.numbers(MotionCost.class, motion.name())[0];
            }
        }
        double rest = Measure.median(times[Motion.REST.ordinal()]);
        double one = Measure.median(times[Motion.ONE_VELOCITY.ordinal()]);
        double ten = Measure.median(times[Motion.TEN_VELOCITIES.ordinal()]);
        measures.add(
                Measure.of("1000 dice that move together, lamp at rest, against the same at rest", "x", one / rest));
        measures.add(Measure.of("1000 dice with ten velocities, lamp at rest, against one velocity", "x", ten / one));
        measureGlass(rounds, measures);
    }

    private static void measureGlass(int rounds, List<Measure> measures) throws IOException, InterruptedException {
        double[][] times = new double[2][rounds];
        for (int round = 0; round < rounds; round++) {
            times[0][round] = OwnProcess.numbers(MotionCost.class, GLASS, "0")[0];
            times[1][round] = OwnProcess.numbers(MotionCost.class, GLASS, "0.5")[0];
        }
        measures.add(Measure.of(
                "a block of glass that moves, against the same at rest",
                "x",
                Measure.median(times[1]) / Measure.median(times[0])));
    }

    /** A block of glass before a wall, with a velocity to the right. */
    private static Studio glass(double beta) {
        Box block = new Box("glass", new Vector3d(-2, -1.5, 0), new Vector3d(2, 1.5, 1.5), Refractive.DEFAULT);
        Moving moving = new Moving("glass", Velocity.of(beta, 0, 0), new Vector3d(0, 0, 8), 0, List.of(block));
        SceneObject wall = new Plane("wall", new Vector3d(0, 0, 12), new Vector3d(0, 0, -1), Tiling.DEFAULT);
        Studio studio = PaperStudios.fig1a().withScene(List.of(wall, moving));
        return studio.withCamera(studio.camera().withShutter(new AperturePlaneShutter(OPENING_TIME)));
    }

    private static Studio studio(Motion motion) {
        List<SceneObject> dice = dice();
        List<SceneObject> scene = motion.velocities == 0
                ? List.of(new Group("dice", dice))
                : IntStream.range(0, motion.velocities)
                        .<SceneObject>mapToObj(i -> moving(dice, i, motion.velocities))
                        .toList();
        Studio studio = PaperStudios.fig1a().withScene(scene);
        return studio.withCamera(studio.camera().withShutter(new AperturePlaneShutter(OPENING_TIME)));
    }

    /** Every so many of the dice, with a velocity of their own. */
    private static Moving moving(List<SceneObject> dice, int first, int step) {
        List<SceneObject> some = IntStream.range(0, dice.size())
                .filter(i -> i % step == first)
                .mapToObj(dice::get)
                .toList();
        double speed = SPEED + 0.01 * first;
        return new Moving("dice", Velocity.of(speed, 0, 0), new Vector3d(), 0, some);
    }

    private static List<SceneObject> dice() {
        Random random = new Random(DICE);
        List<SceneObject> dice = new ArrayList<>();
        for (int i = 0; i < DICE; i++) {
            Vector3d corner =
                    new Vector3d(random.nextDouble(-2, 2), random.nextDouble(-1.5, 1.5), random.nextDouble(8, 12));
            dice.add(new Box("die", corner, new Vector3d(corner).add(EDGE, EDGE, EDGE), Tiling.DEFAULT));
        }
        return dice;
    }
}
