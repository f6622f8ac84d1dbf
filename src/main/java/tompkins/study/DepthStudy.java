package tompkins.study;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.BooleanSupplier;
import org.joml.Vector3d;
import tompkins.camera.ThinLensCamera;
import tompkins.ray.Colour;
import tompkins.render.Quality;
import tompkins.render.RenderJob;
import tompkins.sceneobject.Plane;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;
import tompkins.surface.LuminousSurface;
import tompkins.surface.Mirror;
import tompkins.trace.RenderPlan;

/** When to give up a ray between mirrors. */
final class DepthStudy implements Study {

    private static final String LIMIT = "limit of depth";
    private static final String PROGRAM = "the program: 1/1024 of the light";
    private static final double CUT_OFF = 1.0 / 1024;
    private static final double[] REFLECTANCES = {0.5, 0.9, 0.99};
    private static final int[] DEPTHS = {1, 2, 5, 10, 20, 50, 100, 200, 500};
    private static final double LENGTH = 60;
    private static final double ANGLE = 170;
    private static final int WIDTH = 320;
    private static final int HEIGHT = 3;

    @Override
    public String name() {
        return "depth";
    }

    @Override
    public String question() {
        return "Between mirrors a ray could go on for ever. Is it better to stop it after a number of surfaces, or when it can"
                + " bring too little light? A camera looks down a corridor of two mirrors with reflectance R to a bright"
                + " wall; light that is reflected k times must arrive as R^k, and k follows from the angle.";
    }

    @Override
    public String settings() {
        return String.format(
                Locale.ROOT,
                "corridor 2 wide and %.0f long, %.0f degrees, %d x %d pixels",
                LENGTH,
                ANGLE,
                WIDTH,
                HEIGHT);
    }

    @Override
    public List<Trial> trials() {
        List<Trial> trials = new ArrayList<>();
        for (double reflectance : REFLECTANCES) {
            String problem = problem(reflectance);
            for (int depth : DEPTHS) {
                trials.add(new Trial(
                        problem, LIMIT, depth, cancelled -> measure(problem, LIMIT, reflectance, depth, cancelled)));
            }
            int most = RenderSettings.DEFAULT.maximumDepth();
            trials.add(new Trial(
                    problem, PROGRAM, most, cancelled -> measure(problem, PROGRAM, reflectance, most, cancelled)));
        }
        return trials;
    }

    private static String problem(double reflectance) {
        return String.format(Locale.ROOT, "R=%.2f", reflectance);
    }

    private static Measurement measure(
            String problem, String method, double reflectance, int depth, BooleanSupplier cancelled) {
        RenderPlan plan = RenderPlan.of(corridor(reflectance, depth));
        Repeats runs = new Repeats();
        double rays = 0;
        for (int run = 0; run < 3; run++) {
            RenderJob job = AntialiasingStudy.photograph(plan, new Quality.Samples(1), cancelled);
            double[] errors = new double[WIDTH * HEIGHT];
            for (int pixel = 0; pixel < errors.length; pixel++) {
                Vector3d direction = new Vector3d(plan.chiefDirection(pixel % WIDTH + 0.5, pixel / WIDTH + 0.5));
                errors[pixel] = job.image().value(pixel % WIDTH, pixel / WIDTH, 0)
                        - Math.pow(reflectance, reflections(direction));
            }
            rays = job.report().rays();
            runs.add(ErrorNorm.of(errors), job.report().time().toNanos() / 1e9);
        }
        return runs.measurement(problem, method, depth, rays, 0);
    }

    /** How often light from the axis meets the mirrors at x = -1 and x = 1 before the wall. */
    private static long reflections(Vector3d direction) {
        return (long) Math.floor((Math.abs(direction.x) / direction.z * LENGTH + 1) / 2);
    }

    private static Studio corridor(double reflectance, int depth) {
        ThinLensCamera plain = ThinLensCamera.DEFAULT;
        ThinLensCamera camera = new ThinLensCamera(
                plain.position(),
                plain.viewDirection(),
                plain.topDirection(),
                ANGLE,
                1,
                0,
                plain.focus(),
                0,
                plain.shutter());
        Mirror mirror = new Mirror(reflectance);
        Vector3d across = new Vector3d(1, 0, 0);
        return Studio.DEFAULT
                .withScene(List.of(
                        new Plane("left mirror", new Vector3d(-1, 0, 0), across, mirror),
                        new Plane("right mirror", new Vector3d(1, 0, 0), across, mirror),
                        new Plane(
                                "wall",
                                new Vector3d(0, 0, LENGTH),
                                new Vector3d(0, 0, 1),
                                new LuminousSurface(Colour.WHITE, false))))
                .withCamera(camera)
                .withSettings(RenderSettings.DEFAULT.withSize(WIDTH, HEIGHT).withMaximumDepth(depth));
    }

    @Override
    public List<Chart> charts() {
        List<Chart> charts = new ArrayList<>();
        for (double reflectance : REFLECTANCES) {
            charts.add(new Chart(
                    problem(reflectance),
                    String.format(Locale.ROOT, "Corridor of mirrors, reflectance %.2f", reflectance),
                    Chart.across("rays", Measurement::rays),
                    Chart.ERROR,
                    true));
        }
        return charts;
    }

    @Override
    public List<Finding> findings(List<Measurement> all) {
        List<Finding> findings = new ArrayList<>();
        for (double reflectance : REFLECTANCES) {
            List<Measurement> points = all.stream()
                    .filter(point -> point.problem().equals(problem(reflectance)))
                    .toList();
            Measurement own = points.stream()
                    .filter(point -> point.method().equals(PROGRAM))
                    .findFirst()
                    .orElseThrow();
            double cheapest = points.stream()
                    .filter(point -> point.method().equals(LIMIT))
                    .filter(point -> point.error().middle() <= own.error().middle() * (1 + 1e-9))
                    .mapToDouble(Measurement::rays)
                    .min()
                    .orElse(Double.POSITIVE_INFINITY);
            findings.add(Finding.check(
                    own.maximum() <= CUT_OFF && own.rays() <= cheapest * 1.001,
                    "Reflectance %.2f: the program is wrong by %.2g at most (1/1024 is allowed) with %.0f rays; the cheapest"
                            + " limit of depth that was measured and is as exact takes %.0f rays.",
                    reflectance,
                    own.maximum(),
                    own.rays(),
                    cheapest));
        }
        return findings;
    }
}
