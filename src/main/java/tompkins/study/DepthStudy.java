package tompkins.study;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
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
import tompkins.surface.Refraction;
import tompkins.surface.Refractive;
import tompkins.surface.Surface;
import tompkins.trace.RenderPlan;

/** When to give up a ray between mirrors. */
final class DepthStudy implements Study {

    private static final String TWO_CORRIDORS = "two-corridors";
    private static final String LIMIT = "limit of depth";
    private static final String PROGRAM = StudyText.format("the program: 1/%.0f of the light", 1 / Ray.FAINTEST);
    private static final int[] DEPTHS = {1, 2, 5, 10, 20, 50, 66, 100, 200, 350, 500};
    private static final int REPEATS = 3;
    private static final double CLEARLY_LESS = 0.7;
    private static final double INDEX = 3;
    private static final double LENGTH = 60;
    private static final double ANGLE = 170;
    private static final double ANGLE_THROUGH_GLASS = 100;
    private static final int WIDTH = 320;
    private static final int HEIGHT = 4;

    /**
     * Something to look through.
     *
     * @param title of its chart
     * @param share the largest share of rays that the program may follow, compared with a limit that is as exact
     * @param limited finds the figures with a limit of depth alone
     * @param program finds the program's figures, from its limit of depth
     */
    private record Problem(
            String key, String title, double share, IntFunction<Figures> limited, IntFunction<Figures> program) {}

    private static final List<Problem> PROBLEMS = List.of(
            corridors("R=0.90", "Corridor of mirrors, reflectance 0.90", 1, 0.9, 0.9),
            corridors(
                    TWO_CORRIDORS, "Two corridors in one picture, reflectances 0.99 and 0.50", CLEARLY_LESS, 0.99, 0.5),
            new Problem("glass", "Through a sheet of glass of index 3", 1, DepthStudy::glass, DepthStudy::glass));

    @Override
    public String settings() {
        return StudyText.of("depth.settings", LENGTH, ANGLE, INDEX, ANGLE_THROUGH_GLASS, WIDTH, HEIGHT);
    }

    @Override
    public List<Trial> trials() {
        List<Trial> trials = new ArrayList<>();
        int most = RenderSettings.DEFAULT.maximumDepth();
        for (Problem problem : PROBLEMS) {
            for (int depth : DEPTHS) {
                trials.add(new Trial(problem.key, LIMIT, depth, () -> problem.limited.apply(depth)));
            }
            trials.add(new Trial(problem.key, PROGRAM, most, () -> problem.program.apply(most)));
        }
        return trials;
    }

    /**
     * Corridors with the reflectances of the mirrors above and below the camera. With a limit of depth alone the
     * mirrors are perfect, so that no ray gets faint, and what arrives is dimmed exactly; light that was reflected too
     * often for the limit is missing completely.
     */
    private static Problem corridors(String key, String title, double share, double above, double below) {
        return new Problem(
                key,
                title,
                share,
                depth -> measure(corridors(1, 1, depth), (direction, light) -> {
                    double exact = exact(direction.y > 0 ? above : below, direction);
                    return light * exact - exact;
                }),
                depth -> measure(
                        corridors(above, below, depth),
                        (direction, light) -> light - exact(direction.y > 0 ? above : below, direction)));
    }

    private static Figures glass(int depth) {
        return measure(sheet(depth), (direction, light) -> light - throughGlass(direction));
    }

    /** The error of a pixel, from the direction in which it looks and the light that was found. */
    @FunctionalInterface
    private interface PixelError {

        double of(Vector3d direction, double light);
    }

    private static Figures measure(Studio studio, PixelError error) {
        RenderPlan plan = RenderPlan.of(studio);
        List<Figures> runs = new ArrayList<>();
        for (int run = 0; run < REPEATS; run++) {
            RenderJob job = Photographs.taken(plan, new Quality.Samples(1), () -> false);
            LinearImage image = job.image();
            double[] errors = new double[WIDTH * HEIGHT];
            for (int pixel = 0; pixel < errors.length; pixel++) {
                int column = pixel % WIDTH;
                int row = pixel / WIDTH;
                Vector3d direction = new Vector3d(plan.chiefDirection(column + 0.5, row + 0.5));
                errors[pixel] = error.of(direction, image.value(column, row, 0));
            }
            RenderReport report = job.report();
            runs.add(Figures.of(report.counts().rays, report.time().toNanos() / 1e9, ErrorNorm.of(errors), 0));
        }
        return Figures.of(runs);
    }

    /** R^k, where k is how often light from the axis meets the mirrors at x = -1 and x = 1 before the wall. */
    private static double exact(double reflectance, Vector3d direction) {
        double reflections = Math.floor((Math.abs(direction.x) / direction.z * LENGTH + 1) / 2);
        return Math.pow(reflectance, reflections);
    }

    /** (1 - R)^2 (1 + R^2 + R^4 + ...): what is let through after 0, 2, 4, ... reflections inside. */
    private static double throughGlass(Vector3d direction) {
        Vector3d inside = new Vector3d();
        double cosineInside = Refraction.bend(direction, new Vector3d(0, 0, 1), 1, INDEX, inside);
        double reflected = Refraction.reflectance(1, INDEX, direction.z, cosineInside);
        return (1 - reflected) / (1 + reflected);
    }

    private static Studio corridors(double above, double below, int depth) {
        List<SceneObject> objects = new ArrayList<>();
        objects.add(wall(LENGTH, Colour.WHITE));
        for (int side = -1; side <= 1; side += 2) {
            objects.add(mirror(side, LENGTH, above));
            objects.add(mirror(side, -LENGTH, below));
        }
        return studio(objects, ANGLE, depth);
    }

    private static SceneObject mirror(int side, double height, double reflectance) {
        return new Parallelogram(
                "mirror",
                new Vector3d(side, 0, -1),
                new Vector3d(0, height, 0),
                new Vector3d(0, 0, LENGTH + 2),
                new Mirror(reflectance));
    }

    private static Studio sheet(int depth) {
        Surface glass = new Refractive(INDEX);
        Vector3d back = new Vector3d(0, 0, -1);
        Vector3d forth = new Vector3d(0, 0, 1);
        return studio(
                List.of(
                        wall(LENGTH, Colour.WHITE),
                        wall(-1, Colour.BLACK),
                        new Plane("front", new Vector3d(0, 0, 1), back, glass),
                        new Plane("rear", new Vector3d(0, 0, 2), forth, glass)),
                ANGLE_THROUGH_GLASS,
                depth);
    }

    private static SceneObject wall(double distance, Colour colour) {
        return new Plane(
                "wall", new Vector3d(0, 0, distance), new Vector3d(0, 0, 1), new LuminousSurface(colour, false));
    }

    private static Studio studio(List<SceneObject> objects, double angle, int depth) {
        ThinLensCamera wide = Descriptions.with(ThinLensCamera.DEFAULT, "horizontalAngleDegrees", angle);
        return Studio.DEFAULT
                .withScene(objects)
                .withCamera(Descriptions.with(wide, "verticalAngleDegrees", 1.0))
                .withSettings(RenderSettings.DEFAULT.withSize(WIDTH, HEIGHT).withMaximumDepth(depth));
    }

    @Override
    public List<Chart> charts() {
        return PROBLEMS.stream()
                .map(problem -> new Chart(problem.key, problem.title, Chart.RAYS, Chart.ERROR, true, PROGRAM))
                .toList();
    }

    @Override
    public void conclude(List<Measurement> all, Conclusion conclusion) {
        for (Problem problem : PROBLEMS) {
            Measurement own = Measurement.of(problem.key, PROGRAM, all).get(0);
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
                    own.rays() <= cheapest * problem.share,
                    "depth.rays",
                    problem.title,
                    problem.share < 1 ? problem.share + " times " : "",
                    own.rays(),
                    cheapest);
        }
    }

    /** The fewest rays that a limit follows which is as exact as the program. */
    private static double cheapestLimit(Measurement own, List<Measurement> all) {
        return Measurement.of(own.problem(), LIMIT, all).stream()
                .filter(limit -> limit.medianError() <= own.medianError() * (1 + 1e-9))
                .mapToDouble(Measurement::rays)
                .min()
                .orElse(Double.POSITIVE_INFINITY);
    }
}
