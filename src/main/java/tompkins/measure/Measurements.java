package tompkins.measure;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import org.joml.Vector3dc;
import tompkins.spacetime.Event;
import tompkins.trace.RenderPlan;

/** Measures in the picture of a plan: each result is a list of numbers with their uncertainties. */
public final class Measurements {

    private static final String ANGLE = "degrees";
    private static final String FINE_ANGLE = "arc minutes";
    private static final String LENGTH = "scene units";
    private static final String INTERVAL = "scene units squared";

    /** How exactly a point is known, in pixels. */
    private static final double HALF = 0.5;

    private final RenderPlan plan;
    private final Projection projection;
    private final List<Fact> facts = new ArrayList<>();

    private Measurements(RenderPlan plan, Vector2dc first) {
        this.plan = plan;
        projection = Projection.at(plan.studio(), first);
    }

    /**
     * Measures between points of the picture.
     *
     * @param points in pixels, as many as the kind needs
     * @param goesOn asked now and then while it takes long
     * @return what was measured, or null if it was not to go on
     * @throws ArithmeticException if the points do not tell what is asked
     */
    public static Measured measure(RenderPlan plan, MeasureKind kind, List<Vector2dc> points, BooleanSupplier goesOn) {
        Measurements all = new Measurements(plan, points.get(0));
        return switch (kind) {
            case BETWEEN -> all.between(points);
            case PROFILE -> all.profile(points, goesOn);
            case CIRCLE -> all.circle(points);
            case LINE -> all.line(points);
        };
    }

    /** Where the brightness of a profile has its largest step; nothing if there is no edge. */
    private Measured profile(List<Vector2dc> points, BooleanSupplier goesOn) {
        List<Sighting> profile = Sighting.along(plan, points.get(0), points.get(1), goesOn);
        if (profile == null) {
            return null;
        }
        new Edges(plan).largestStep(profile).ifPresent(point -> addPixel(facts, "edge", "edge", point));
        return new Measured(facts, profile, List.of(points));
    }

    /**
     * Angles, lengths and times between two points: from events of emission, in the scene frame, in the camera frame
     * and in the frame of the object, if that is one; without hits the angles alone. The interval is the same in all
     * frames of relativity: that both agree is a check.
     */
    private Measured between(List<Vector2dc> points) {
        Sighting first = at(points.get(0));
        Sighting second = at(points.get(1));
        Separation both = new Separation(first, second);
        double firstPixel = pixelAngle(points.get(0));
        double secondPixel = pixelAngle(points.get(1));
        addAngle("cameraAngle", "angle (camera)", both.cameraAngle(), HALF * Math.hypot(firstPixel, secondPixel));
        if (!Double.isNaN(both.sceneAngle())) {
            double pixel =
                    Math.hypot(firstPixel * first.sceneDopplerFactor(), secondPixel * second.sceneDopplerFactor());
            addAngle("sceneAngle", "angle (scene)", both.sceneAngle(), HALF * pixel);
        }
        if (both.hasHits()) {
            Changes<Separation> changes = new Changes<>(
                    both,
                    List.of(
                            beside(first)
                                    .map(other -> new Separation(other, second))
                                    .toList(),
                            beside(second)
                                    .map(other -> new Separation(first, other))
                                    .toList()));
            addDifference(changes, "scene", Separation::inScene);
            addDifference(changes, "camera", Separation::inCamera);
            if (both.inObject() != null) {
                addDifference(changes, "object", Separation::inObject);
            }
            addInterval(changes, "scene", Separation::inScene);
            addInterval(changes, "camera", Separation::inCamera);
        }
        return new Measured(facts, null, List.of(points));
    }

    private void addDifference(Changes<Separation> changes, String frame, Function<Separation, Event> difference) {
        facts.add(changes.quantity(
                frame + "Distance",
                "distance (" + frame + ")",
                LENGTH,
                one -> difference.apply(one).position().length()));
        facts.add(changes.quantity(
                frame + "Time",
                "dt (" + frame + ")",
                LENGTH,
                one -> difference.apply(one).time()));
    }

    private void addInterval(Changes<Separation> changes, String frame, Function<Separation, Event> difference) {
        facts.add(changes.quantity(
                frame + "Interval",
                "dr^2 - dt^2 (" + frame + ")",
                INTERVAL,
                one -> Separation.interval(difference.apply(one))));
    }

    /**
     * What points tell, and how half a pixel changes it.
     *
     * @param told what they tell
     * @param beside for each point, what they tell with that one moved to all sides; empty if that is not known
     */
    private record Changes<T>(T told, List<List<T>> beside) {

        Quantity quantity(String key, String name, String unit, ToDoubleFunction<T> number) {
            return new Quantity(key, name, unit, number.applyAsDouble(told), uncertainty(number));
        }

        double uncertainty(ToDoubleFunction<T> number) {
            double squares = 0;
            for (List<T> others : beside) {
                double most = others.stream()
                        .mapToDouble(other -> Math.abs(number.applyAsDouble(other) - number.applyAsDouble(told)))
                        .max()
                        .orElse(Double.NaN);
                squares += most * most;
            }
            return Math.sqrt(squares);
        }
    }

    /** Half a pixel beside a position, to all sides. */
    private static Stream<Vector2d> around(double x, double y) {
        return Stream.of(
                new Vector2d(x + HALF, y),
                new Vector2d(x - HALF, y),
                new Vector2d(x, y + HALF),
                new Vector2d(x, y - HALF));
    }

    /** What is half a pixel beside a point, to all sides; nothing at an edge, beyond which another object is seen. */
    private Stream<Sighting> beside(Sighting sighting) {
        List<Sighting> beside = around(sighting.x(), sighting.y()).map(this::at).toList();
        return beside.stream()
                        .allMatch(other -> other.sharesFrame(sighting)
                                && other.hit().object() == sighting.hit().object())
                ? beside.stream()
                : Stream.empty();
    }

    private Sighting at(Vector2dc point) {
        return Sighting.of(plan, point.x(), point.y());
    }

    /** The circle through some points, as the outline of a sphere, and by how much the points miss it. */
    private Measured circle(List<Vector2dc> points) {
        CircleFit fit = CircleFit.of(directions(points));
        Changes<LookCone> changes = new Changes<>(
                fit.circle(),
                IntStream.range(0, points.size())
                        .mapToObj(moved -> circlesBeside(points, moved))
                        .toList());
        Vector3dc axis = fit.circle().axis();
        addAngle("halfAngle", "half-angle", fit.circle().halfAngle(), changes.uncertainty(LookCone::halfAngle));
        addFineAngle("residual", "rms deviation", fit.residual(), HALF * pixelAngle(points));
        addDirection("middle", "direction of the centre", axis);
        Vector2dc middle = projection.position(axis);
        if (middle != null) {
            addPixel(facts, "middle", "centre", middle);
        }
        if (!plan.isAtRest()) {
            ToDoubleFunction<LookCone> toMotion = circle ->
                    Angles.between(circle.axis(), plan.studio().velocity().direction());
            addAngle(
                    "middleAngleToVelocity",
                    "centre, angle to motion",
                    toMotion.applyAsDouble(fit.circle()),
                    changes.uncertainty(toMotion));
        }
        return new Measured(facts, null, fit.circle().lines(projection));
    }

    /** The circles with one point moved by half a pixel, to all sides; none if it tells no circle then. */
    private List<LookCone> circlesBeside(List<Vector2dc> points, int moved) {
        List<Vector3dc> directions = new ArrayList<>(directions(points));
        Vector2dc point = points.get(moved);
        List<LookCone> circles = new ArrayList<>();
        try {
            for (Vector2dc beside : around(point.x(), point.y()).toList()) {
                directions.set(moved, plan.chiefDirection(beside.x(), beside.y()));
                circles.add(CircleFit.of(directions).circle());
            }
        } catch (ArithmeticException noCircle) {
            return List.of();
        }
        return circles;
    }

    /** What a lens shows as a straight line through points: by how much they miss it, and how long it is. */
    private Measured line(List<Vector2dc> points) {
        List<Vector3dc> directions = directions(points);
        LineFit fit = LineFit.of(directions);
        double pixel = pixelAngle(points);
        addFineAngle("residual", "rms deviation", fit.residual(), HALF * pixel);
        addFineAngle("largestMiss", "largest deviation", fit.worst(), HALF * pixel);
        facts.add(new Quantity("residualInPixels", "rms deviation", "pixels", fit.residual() / pixel, HALF));
        double length = Angles.between(directions.get(0), directions.get(directions.size() - 1));
        addAngle("length", "length", length, HALF * Math.sqrt(2) * pixel);
        addDirection("normal", "normal of the plane", fit.normal());
        return new Measured(facts, null, LookCone.across(fit.normal()).lines(projection));
    }

    private List<Vector3dc> directions(List<Vector2dc> points) {
        return points.stream()
                .map(point -> plan.chiefDirection(point.x(), point.y()))
                .toList();
    }

    private double pixelAngle(Vector2dc point) {
        return Projection.at(plan.studio(), point).pixelAngle(point.x(), point.y());
    }

    private double pixelAngle(List<Vector2dc> points) {
        return points.stream().mapToDouble(this::pixelAngle).max().orElse(Double.NaN);
    }

    private void addAngle(String key, String name, double radians, double uncertainty) {
        facts.add(new Quantity(key, name, ANGLE, Math.toDegrees(radians), Math.toDegrees(uncertainty)));
    }

    private void addFineAngle(String key, String name, double radians, double uncertainty) {
        facts.add(new Quantity(key, name, FINE_ANGLE, radians * Angles.ARC_MINUTES, uncertainty * Angles.ARC_MINUTES));
    }

    private void addDirection(String key, String name, Vector3dc direction) {
        facts.add(Quantity.exact(key + "X", "", "", direction.x()));
        facts.add(Quantity.exact(key + "Y", "", "", direction.y()));
        facts.add(Quantity.exact(key + "Z", "", "", direction.z()));
        facts.add(new Fact.Vector("", name, direction));
    }

    /** Column and row of a point, which is given in pixels from the corner. */
    static void addPixel(List<Fact> facts, String key, String name, Vector2dc point) {
        facts.add(Quantity.exact(key + "PixelX", "", "pixels", point.x() - HALF));
        facts.add(Quantity.exact(key + "PixelY", "", "pixels", point.y() - HALF));
        facts.add(new Fact.Vector("", name + " (column, row)", List.of(point.x() - HALF, point.y() - HALF)));
    }
}
