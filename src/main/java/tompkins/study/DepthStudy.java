package tompkins.study;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import tompkins.camera.ThinLensCamera;
import tompkins.image.LinearImage;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.ray.Ray;
import tompkins.render.Quality;
import tompkins.render.RenderJob;
import tompkins.render.RenderReport;
import tompkins.sceneobject.Parallelogram;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;
import tompkins.surface.LuminousSurface;
import tompkins.surface.Mirror;
import tompkins.trace.RenderPlan;

/** When to give up a ray between mirrors. */
final class DepthStudy implements Study {

    private static final String TWO_CORRIDORS = "two-corridors";
    private static final String LIMIT = "limit of depth";
    private static final String PROGRAM = StudyText.format("the program: 1/%.0f of the light", 1 / Ray.FAINTEST);
    private static final int[] DEPTHS = {1, 2, 5, 10, 20, 50, 66, 100, 200, 350, 500};
    private static final double CLEARLY_LESS = 0.7;
    private static final double LENGTH = 60;
    private static final double ANGLE = 170;
    private static final int WIDTH = 320;
    private static final int HEIGHT = 4;

    /**
     * Something to look through.
     *
     * @param title of its chart
     * @param part the largest part of the rays that the program may follow, compared with a limit that is as exact
     * @param above the reflectance of the mirrors above the camera
     * @param below the reflectance of the mirrors below it
     */
    private record Problem(String key, String title, double part, double above, double below) {}

    private static final List<Problem> PROBLEMS = List.of(
            new Problem("R=0.90", "Corridor of mirrors, reflectance 0.90", 1, 0.9, 0.9),
            new Problem(
                    TWO_CORRIDORS,
                    "Two corridors in one picture, reflectances 0.99 and 0.50",
                    CLEARLY_LESS,
                    0.99,
                    0.5));

    @Override
    public String settings() {
        return StudyText.of("depth.settings", LENGTH, ANGLE, WIDTH, HEIGHT);
    }

    @Override
    public List<Trial> trials() {
        List<Trial> trials = new ArrayList<>();
        int most = RenderSettings.DEFAULT.maximumDepth();
        for (Problem problem : PROBLEMS) {
            for (int depth : DEPTHS) {
                trials.add(new Trial(problem.key, LIMIT, depth, () -> measure(problem, true, depth)));
            }
            trials.add(new Trial(problem.key, PROGRAM, most, () -> measure(problem, false, most)));
        }
        return trials;
    }

    /**
     * Measures with a limit of depth. With that alone the mirrors are perfect, so that no ray gets faint, and what
     * arrives is dimmed exactly; light that was reflected too often for the limit is missing completely.
     */
    private static Figures measure(Problem problem, boolean alone, int depth) {
        RenderPlan plan =
                RenderPlan.of(alone ? corridors(1, 1, depth) : corridors(problem.above, problem.below, depth));
        RenderJob job = Photographs.taken(plan, new Quality.Samples(1), () -> false);
        LinearImage image = job.image();
        double[] errors = new double[WIDTH * HEIGHT];
        for (int pixel = 0; pixel < errors.length; pixel++) {
            int column = pixel % WIDTH;
            int row = pixel / WIDTH;
            Vector3d direction = new Vector3d(plan.chiefDirection(column + 0.5, row + 0.5));
            double exact = exact(direction.y > 0 ? problem.above : problem.below, direction);
            double light = image.value(column, row, 0);
            errors[pixel] = (alone ? light * exact : light) - exact;
        }
        RenderReport report = job.report();
        return Figures.of(report.counts().rays, report.time().toNanos() / 1e9, errors, 0);
    }

    /** R^k, where k is how often light from the axis meets the mirrors at x = -1 and x = 1 before the wall. */
    private static double exact(double reflectance, Vector3d direction) {
        double reflections = Math.floor((Math.abs(direction.x) / direction.z * LENGTH + 1) / 2);
        return Math.pow(reflectance, reflections);
    }

    private static Studio corridors(double above, double below, int depth) {
        List<SceneObject> objects = new ArrayList<>();
        objects.add(new Plane(
                "wall", new Vector3d(0, 0, LENGTH), new Vector3d(0, 0, 1), new LuminousSurface(Colour.WHITE, false)));
        for (int side = -1; side <= 1; side += 2) {
            objects.add(mirror(side, LENGTH, above));
            objects.add(mirror(side, -LENGTH, below));
        }
        ThinLensCamera wide = Descriptions.with(ThinLensCamera.DEFAULT, "horizontalAngleDegrees", ANGLE);
        return Studio.DEFAULT
                .withScene(objects)
                .withCamera(Descriptions.with(wide, "verticalAngleDegrees", 1.0))
                .withSettings(Descriptions.with(RenderSettings.DEFAULT.withSize(WIDTH, HEIGHT), "maximumDepth", depth));
    }

    private static SceneObject mirror(int side, double height, double reflectance) {
        return new Parallelogram(
                "mirror",
                new Vector3d(side, 0, -1),
                new Vector3d(0, height, 0),
                new Vector3d(0, 0, LENGTH + 2),
                new Mirror(reflectance));
    }

    @Override
    public List<Chart> charts() {
        return PROBLEMS.stream()
                .map(problem -> new Chart(problem.key, problem.title, Chart.RAYS, Chart.ERROR, true, PROGRAM))
                .toList();
    }

    @Override
    public void conclude(List<StudyPoint> all, Conclusion conclusion) {
        for (Problem problem : PROBLEMS) {
            StudyPoint own = StudyPoint.of(problem.key, PROGRAM, all).get(0);
            double cheapest = cheapestLimit(own, all);
            if (problem.key.equals(TWO_CORRIDORS)) {
                conclusion.say("depth.answer", cheapest / own.rays(), 1 / Ray.FAINTEST);
            }
            conclusion.demand(
                    own.maximum() <= Ray.FAINTEST,
                    "depth.error",
                    problem.title,
                    1 / Ray.FAINTEST,
                    Ray.FAINTEST,
                    own.maximum());
            conclusion.demand(
                    own.rays() <= cheapest * problem.part,
                    "depth.rays",
                    problem.title,
                    problem.part < 1 ? problem.part + " times " : "",
                    own.rays(),
                    cheapest);
        }
    }

    /** The fewest rays that a limit follows which is as exact as the program. */
    private static double cheapestLimit(StudyPoint own, List<StudyPoint> all) {
        return StudyPoint.of(own.problem(), LIMIT, all).stream()
                .filter(limit -> limit.medianError() <= own.medianError() * (1 + 1e-9))
                .mapToDouble(StudyPoint::rays)
                .min()
                .orElse(Double.POSITIVE_INFINITY);
    }
}
