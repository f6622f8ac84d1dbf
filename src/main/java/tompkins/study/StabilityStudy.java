package tompkins.study;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.BiFunction;
import java.util.function.ToDoubleFunction;
import org.joml.Vector3d;
import tompkins.property.InvalidPropertyException;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.sceneobject.Sphere;
import tompkins.search.NearestHit;
import tompkins.search.ObjectTree;
import tompkins.spacetime.LorentzTransformation;
import tompkins.spacetime.Velocity;
import tompkins.surface.ColouredSurface;

/**
 * What happens close to the places where formulas lose their digits.
 *
 * @param seed of the cases
 */
record StabilityStudy(long seed) implements Study {

    private static final String STABLE = "the program";
    private static final String NAIVE = "textbook formula";
    private static final MathContext DIGITS = new MathContext(60);
    private static final int CASES = 200;
    private static final double GOOD = 1e-14;
    private static final double MUCH = 1000;
    private static final double NOTHING_LEFT = 1;
    private static final double SMALLEST = 0x1p-53;

    /**
     * A place where formulas fail.
     *
     * @param title of its chart
     * @param distance what the axis across shows: the distance from the place
     * @param nearest exponent of 10 of the smallest distance that is measured; the largest is 10^-1
     * @param errors the relative errors of both formulas in one case: first the program's, then the textbook's
     */
    private record Place(
            String key,
            String title,
            String distance,
            int nearest,
            BiFunction<Double, SplittableRandom, double[]> errors) {}

    private static final List<Place> PLACES = List.of(
            new Place("light", "gamma of a speed close to that of light", "1 - beta", -15, StabilityStudy::nearLight),
            new Place("rest", "gamma - 1 of a low speed", "beta", -9, StabilityStudy::nearRest),
            new Place(
                    "fixed-point",
                    "time of the fixed-point surface, low speed",
                    "beta",
                    -9,
                    StabilityStudy::fixedPoint),
            new Place("far-sphere", "distance of a small sphere", "radius / distance", -7, StabilityStudy::farSphere));

    @Override
    public String settings() {
        return StudyText.of("stability.settings", seed, CASES);
    }

    @Override
    public List<Trial> trials() {
        List<Trial> trials = new ArrayList<>();
        for (Place place : PLACES) {
            for (String method : List.of(STABLE, NAIVE)) {
                for (int exponent = -1; exponent >= place.nearest; exponent--) {
                    double distance = Double.parseDouble("1e" + exponent);
                    trials.add(new Trial(place.key, method, distance, () -> measure(place, method, distance)));
                }
            }
        }
        return trials;
    }

    private Figures measure(Place place, String method, double distance) {
        SplittableRandom random = new SplittableRandom(seed);
        // an error of 0 would have no place on a logarithmic axis
        double largest = SMALLEST;
        for (int i = 0; i < CASES; i++) {
            double error = place.errors.apply(distance, random)[method.equals(STABLE) ? 0 : 1];
            largest = Math.max(largest, Double.isNaN(error) ? NOTHING_LEFT : Math.min(NOTHING_LEFT, Math.abs(error)));
        }
        return Figures.of(CASES, 0, largest);
    }

    private static Vector3d velocity(double speed, SplittableRandom random) {
        Vector3d direction;
        do {
            direction = ChordStudy.inBall(random);
        } while (direction.lengthSquared() < 0.1);
        return direction.normalize(speed);
    }

    private static BigDecimal dot(Vector3d a, Vector3d b) {
        return PrecisionStudy.dot(PrecisionStudy.decimals(a), PrecisionStudy.decimals(b));
    }

    private static BigDecimal gamma(Vector3d beta) {
        return BigDecimal.ONE.divide(BigDecimal.ONE.subtract(dot(beta, beta)).sqrt(DIGITS), DIGITS);
    }

    private static double relative(double found, BigDecimal exact) {
        return Double.isFinite(found)
                ? new BigDecimal(found).subtract(exact).divide(exact, DIGITS).doubleValue()
                : Double.NaN;
    }

    private static double[] nearLight(double distance, SplittableRandom random) {
        Vector3d beta = velocity(1 - distance, random);
        while (dot(beta, beta).compareTo(BigDecimal.ONE) >= 0) {
            beta = velocity(1 - distance, random);
        }
        BigDecimal exact = gamma(beta);
        double naive = 1 / Math.sqrt(1 - beta.lengthSquared());
        return new double[] {relative(program(beta, Velocity::gamma), exact), relative(naive, exact)};
    }

    private static double[] nearRest(double distance, SplittableRandom random) {
        Vector3d beta = velocity(distance, random);
        BigDecimal exact = gamma(beta).subtract(BigDecimal.ONE);
        double naive = 1 / Math.sqrt(1 - beta.lengthSquared()) - 1;
        return new double[] {relative(program(beta, Velocity::gammaMinusOne), exact), relative(naive, exact)};
    }

    private static double program(Vector3d beta, ToDoubleFunction<Velocity> figure) {
        try {
            return figure.applyAsDouble(Velocity.of(beta));
        } catch (InvalidPropertyException refused) {
            return Double.NaN;
        }
    }

    /** (1 - gamma)(beta.x)/(gamma beta^2) as in the paper; x along beta, so that the product itself loses nothing. */
    private static double[] fixedPoint(double distance, SplittableRandom random) {
        Vector3d beta = velocity(distance, random);
        Vector3d place = new Vector3d(beta).mul(random.nextDouble(1, 2) / distance);
        BigDecimal gamma = gamma(beta);
        BigDecimal exact = dot(beta, place).multiply(gamma).negate().divide(gamma.add(BigDecimal.ONE), DIGITS);
        double found = new LorentzTransformation(Velocity.of(beta)).fixedPointTime(place);
        double plain = 1 / Math.sqrt(1 - beta.lengthSquared());
        double naive = (1 - plain) * beta.dot(place) / (plain * beta.lengthSquared());
        return new double[] {relative(found, exact), relative(naive, exact)};
    }

    /** The distance of a sphere of radius 1 from a ray that misses its centre by up to 0.9. */
    private static double[] farSphere(double distance, SplittableRandom random) {
        double far = 1 / distance;
        double offset = random.nextDouble(-0.9, 0.9);
        Vector3d centre = new Vector3d(offset, 0, far);
        BigDecimal exact = new BigDecimal(far)
                .subtract(BigDecimal.ONE.subtract(new BigDecimal(offset).pow(2)).sqrt(DIGITS));
        Ray ray = Ray.from(0, 0, 0, 0, 0, 1, 0);
        NearestHit nearest = new NearestHit(new RayCounts());
        boolean hit = new ObjectTree(
                        PrimitiveCollector.primitivesOf(new Sphere("sphere", centre, 1, ColouredSurface.DEFAULT)))
                .nearest(ray, nearest);
        // the textbook's quadratic equation t^2 + 2 b t + c = 0
        double b = -far;
        double c = centre.lengthSquared() - 1;
        double naive = -b - Math.sqrt(b * b - c);
        return new double[] {relative(hit ? nearest.distance() : Double.NaN, exact), relative(naive, exact)};
    }

    @Override
    public List<Chart> charts() {
        Chart.Axis error = new Chart.Axis("largest relative error", StudyPoint::error);
        return PLACES.stream()
                .map(place -> new Chart(place.key, place.title, Chart.setting(place.distance), error, false, STABLE))
                .toList();
    }

    @Override
    public void conclude(List<StudyPoint> all, Conclusion conclusion) {
        conclusion.say("stability.answer");
        for (Place place : PLACES) {
            double stable = worst(place, STABLE, all);
            double naive = worst(place, NAIVE, all);
            conclusion.demand(
                    stable < GOOD && naive > MUCH * stable,
                    "stability.worst",
                    StudyPage.heading(place.title),
                    GOOD,
                    MUCH,
                    stable,
                    naive);
        }
    }

    private static double worst(Place place, String method, List<StudyPoint> all) {
        return StudyPoint.of(place.key, method, all).stream()
                .mapToDouble(point -> point.medianError())
                .max()
                .orElse(Double.NaN);
    }
}
