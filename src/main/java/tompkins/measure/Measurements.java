package tompkins.measure;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
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

    /** How exactly a place is known, in pixels. */
    private static final double HALF = 0.5;

    private final RenderPlan plan;
    private final Projection projection;

    /** Measures in a picture. */
    public Measurements(RenderPlan plan) {
        this.plan = plan;
        projection = Projection.of(plan.studio());
    }

    /**
     * Measures between places of the picture.
     *
     * @param places in pixels, as many as the kind needs
     * @param count number of places of a profile, 2 to {@link Profile#MOST}
     * @param goesOn asked now and then while it takes long
     * @return what was measured, or null if it was not to go on
     * @throws ArithmeticException if the places do not tell what is asked
     */
    public Measured measure(MeasureKind kind, List<Vector2dc> places, int count, BooleanSupplier goesOn) {
        Vector2dc first = places.get(0);
        Vector2dc second = places.get(1);
        return switch (kind) {
            case CIRCLE ->
                new Measured(
                        kind,
                        circle(places),
                        null,
                        lines(CircleFit.of(directions(places)).circle()));
            case CONIC -> new ConicMeasurement(projection).measure(places, HALF);
            case LINE -> {
                Vector3dc normal = LineFit.of(directions(places)).normal();
                yield new Measured(kind, line(places), null, lines(LookCone.across(normal)));
            }
            case BETWEEN ->
                new Measured(
                        kind,
                        between(at(first.x(), first.y()), at(second.x(), second.y())),
                        null,
                        List.of(List.of(first, second)));
            case PROFILE -> {
                Profile profile = Profile.between(plan, first.x(), first.y(), second.x(), second.y(), count, goesOn);
                yield profile == null
                        ? null
                        : new Measured(kind, edge(profile), profile, List.of(List.of(first, second)));
            }
        };
    }

    private List<List<Vector2dc>> lines(LookCone circle) {
        return CurveTracer.lines(projection, 0, 2 * Math.PI, azimuth -> projection.place(circle.direction(azimuth)));
    }

    /** Where the brightness of a profile has its largest step; nothing if there is none. */
    private static List<Quantity> edge(Profile profile) {
        double[] edge = profile.edge(Measurements::brightness);
        if (edge == null) {
            return List.of();
        }
        Sighting first = profile.places().get(0);
        Sighting last = profile.places().get(profile.places().size() - 1);
        double spacing = Math.hypot(last.x() - first.x(), last.y() - first.y())
                / (profile.places().size() - 1);
        return List.of(
                new Quantity("edgePixelX", "pixels", edge[0] - HALF, HALF * spacing),
                new Quantity("edgePixelY", "pixels", edge[1] - HALF, HALF * spacing));
    }

    private static double brightness(Sighting sighting) {
        return sighting.life() == null
                ? 0
                : (sighting.life().colour().red()
                                + sighting.life().colour().green()
                                + sighting.life().colour().blue())
                        / 3;
    }

    /** What a place shows. */
    public Sighting at(double x, double y) {
        return Sighting.of(plan, x, y);
    }

    /**
     * Angles, lengths and times between two sightings: from events of emission, in the scene frame, in the camera frame
     * and in the frame of the object, if that is one; without hits the angles alone. The interval is the same in all
     * frames of relativity: that both agree is a check.
     */
    public List<Quantity> between(Sighting first, Sighting second) {
        Separation both = new Separation(first, second);
        List<Quantity> results = new ArrayList<>();
        double pixel = HALF * Math.hypot(pixelAngle(first), pixelAngle(second));
        double scenePixel = HALF
                * Math.hypot(pixelAngle(first) * first.dopplerFactor(), pixelAngle(second) * second.dopplerFactor());
        results.add(angle("cameraAngle", both.cameraAngle(), pixel));
        if (!Double.isNaN(both.sceneAngle())) {
            results.add(angle("sceneAngle", both.sceneAngle(), scenePixel));
        }
        if (both.hasHits()) {
            addDifference(results, "scene", both.inScene(), miss(first, Frames.SCENE), miss(second, Frames.SCENE));
            addDifference(results, "camera", both.inCamera(), miss(first, Frames.CAMERA), miss(second, Frames.CAMERA));
            if (both.inObject() != null) {
                addDifference(results, "object", both.inObject(), miss(first, Frames.OWN), miss(second, Frames.OWN));
            }
            results.add(Quantity.exact("sceneInterval", INTERVAL, Separation.interval(both.inScene())));
            results.add(Quantity.exact("cameraInterval", INTERVAL, Separation.interval(both.inCamera())));
        }
        return results;
    }

    private static void addDifference(
            List<Quantity> results, String frame, Event difference, double firstMiss, double secondMiss) {
        results.add(new Quantity(
                frame + "Distance", LENGTH, Separation.length(difference), Math.hypot(firstMiss, secondMiss)));
        results.add(Quantity.exact(frame + "Time", LENGTH, Separation.time(difference)));
    }

    /** The frames in which events are told. */
    private enum Frames {
        SCENE,
        CAMERA,
        OWN;

        Event event(Sighting sighting) {
            return switch (this) {
                case SCENE -> sighting.inScene();
                case CAMERA -> sighting.inCamera();
                case OWN -> sighting.hit().rest().event();
            };
        }
    }

    /** How far the place of a hit moves with half a pixel; NaN at an edge, beyond which another object is seen. */
    private double miss(Sighting sighting, Frames frame) {
        Event here = frame.event(sighting);
        double most = 0;
        for (double[] step : new double[][] {{HALF, 0}, {-HALF, 0}, {0, HALF}, {0, -HALF}}) {
            Sighting beside = at(sighting.x() + step[0], sighting.y() + step[1]);
            if (!beside.sharesFrame(sighting)
                    || beside.hit().object() != sighting.hit().object()) {
                return Double.NaN;
            }
            most = Math.max(most, Separation.length(frame.event(beside).minus(here)));
        }
        return most;
    }

    /**
     * The circle through some places, as the outline of a sphere: its middle, its half-angle, and by how much the
     * places miss it.
     *
     * @throws ArithmeticException if the places do not tell a circle
     */
    public List<Quantity> circle(List<Vector2dc> places) {
        CircleFit fit = CircleFit.of(directions(places));
        List<Quantity> results = new ArrayList<>();
        double pixel = pixelAngle(places) * HALF / Math.sqrt(places.size());
        results.add(angle("halfAngle", fit.circle().halfAngle(), pixel));
        results.add(new Quantity("residual", FINE_ANGLE, fit.residual() * Angles.ARC_MINUTES, Double.NaN));
        addDirection(results, "middle", fit.circle().axis());
        Vector2dc middle = projection.place(fit.circle().axis());
        if (middle != null) {
            results.add(Quantity.exact("middlePixelX", "pixels", middle.x() - HALF));
            results.add(Quantity.exact("middlePixelY", "pixels", middle.y() - HALF));
        }
        if (!plan.isAtRest()) {
            Vector3dc ahead = plan.studio().velocity().direction();
            results.add(
                    angle("middleAngleToVelocity", Angles.between(fit.circle().axis(), ahead), pixel));
        }
        return results;
    }

    /**
     * The straight line through some places: by how much they miss the great circle that a lens shows as a straight
     * line, and how long it is.
     *
     * @throws ArithmeticException if the places do not tell a line
     */
    public List<Quantity> line(List<Vector2dc> places) {
        List<? extends Vector3dc> directions = directions(places);
        LineFit fit = LineFit.of(directions);
        double pixel = pixelAngle(places);
        List<Quantity> results = new ArrayList<>();
        results.add(new Quantity(
                "residual", FINE_ANGLE, fit.residual() * Angles.ARC_MINUTES, HALF * pixel * Angles.ARC_MINUTES));
        results.add(new Quantity(
                "largestMiss", FINE_ANGLE, fit.worst() * Angles.ARC_MINUTES, HALF * pixel * Angles.ARC_MINUTES));
        results.add(Quantity.exact("residualInPixels", "pixels", fit.residual() / pixel));
        double length = Angles.between(directions.get(0), directions.get(directions.size() - 1));
        results.add(angle("length", length, HALF * Math.sqrt(2) * pixel));
        addDirection(results, "normal", fit.normal());
        return results;
    }

    private List<? extends Vector3dc> directions(List<Vector2dc> places) {
        return places.stream()
                .map(place -> projection.direction(place.x(), place.y()))
                .toList();
    }

    private double pixelAngle(Sighting sighting) {
        return projection.pixelAngle(sighting.x(), sighting.y());
    }

    private double pixelAngle(List<Vector2dc> places) {
        return places.stream()
                .mapToDouble(place -> projection.pixelAngle(place.x(), place.y()))
                .max()
                .orElse(Double.NaN);
    }

    private static Quantity angle(String key, double radians, double uncertainty) {
        return new Quantity(key, ANGLE, Math.toDegrees(radians), Math.toDegrees(uncertainty));
    }

    private static void addDirection(List<Quantity> results, String name, Vector3dc direction) {
        results.add(Quantity.exact(name + "X", "", direction.x()));
        results.add(Quantity.exact(name + "Y", "", direction.y()));
        results.add(Quantity.exact(name + "Z", "", direction.z()));
    }
}
