package tompkins.measure;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import org.joml.Vector3dc;
import tompkins.lesson.AngleBetween;
import tompkins.lesson.CircleRadius;
import tompkins.lesson.DifferenceOf;
import tompkins.lesson.LensSpread;
import tompkins.lesson.LessonControl;
import tompkins.lesson.Measurement;
import tompkins.lesson.MeasuringPoint;
import tompkins.lesson.OnRide;
import tompkins.lesson.PictureEdge;
import tompkins.lesson.PicturePoint;
import tompkins.lesson.RatioOf;
import tompkins.lesson.RayReading;
import tompkins.lesson.RayValue;
import tompkins.lesson.StarCount;
import tompkins.lesson.WithNumber;
import tompkins.lesson.WithShutter;
import tompkins.property.InvalidPropertyException;
import tompkins.property.NumberText;
import tompkins.spacetime.Event;
import tompkins.studio.RideMoment;
import tompkins.studio.StarSky;
import tompkins.studio.Studio;
import tompkins.studio.StudioNumber;
import tompkins.studio.StudioPath;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;

/**
 * Measures the measurements of lessons in the picture of one studio. It only follows rays, which takes milliseconds.
 */
public final class Experiment {

    private final LessonControl control;
    private final RenderPlan plan;

    /** In what this picture differs from the others of the lesson. */
    private final String caption;

    /** All pictures in which was measured, with their captions. */
    private final Map<Studio, String> pictures;

    /** Where the last measurement measured in this picture. */
    private final List<Vector2dc> points = new ArrayList<>();

    private final List<List<Vector2dc>> lines = new ArrayList<>();

    /**
     * An experiment with a studio.
     *
     * @param control the slider of the lesson; where a measurement sets the same number, it stays on the slider
     * @throws InvalidPropertyException if an object of the studio is too large or too small to work with
     */
    public Experiment(Studio studio, LessonControl control) {
        this(RenderPlan.of(studio), control, caption(control.name(), control.measuredAt()), new LinkedHashMap<>());
        pictures.put(studio, caption);
    }

    private Experiment(RenderPlan plan, LessonControl control, String caption, Map<Studio, String> pictures) {
        this.plan = plan;
        this.control = control;
        this.caption = caption;
        this.pictures = pictures;
    }

    private static String caption(String name, double value) {
        return name + ": " + NumberText.of(value);
    }

    /** An experiment with another studio, which takes over the scene if that is the same. */
    private Experiment with(Studio studio, String itsCaption) {
        return new Experiment(RenderPlan.of(studio, plan), control, itsCaption, pictures);
    }

    /** The studios of all pictures in which was measured, and in what each differs from the others. */
    Map<Studio, String> pictures() {
        return pictures;
    }

    /**
     * The value of a measurement: lengths and times in scene units, angles in degrees.
     *
     * @param path the way to the measurement in the studio, for messages
     * @throws InvalidPropertyException if it cannot be measured here: the edge, the object or the number is missing
     */
    public double measure(Measurement measurement, String path) {
        double measured = value(measurement, path);
        if (!Double.isFinite(measured)) {
            throw new InvalidPropertyException(path, "one that has a value in this picture", measured);
        }
        return measured;
    }

    private double value(Measurement measurement, String path) {
        if (measurement instanceof DifferenceOf difference) {
            // the later one minus the earlier one
            double second = measure(difference.second(), path + ".second");
            double value = measure(difference.first(), path + ".first") - second;
            if (points.size() == 2 && lines.isEmpty()) {
                lines.add(List.copyOf(points));
            }
            return value;
        }
        if (measurement instanceof RatioOf ratio) {
            return measure(ratio.first(), path + ".first") / measure(ratio.second(), path + ".second");
        }
        if (measurement instanceof WithNumber other) {
            Studio changed = at(path, () -> studio(other));
            String name = isControl(other) ? control.name() : other.number();
            Experiment there = changed.equals(studio()) ? this : with(changed, caption(name, other.value()));
            double value = there.measure(other.measurement(), path + ".measurement");
            if (there != this && isOneView(changed)) {
                // another moment of the same view
                add(there.sketch());
            }
            return value;
        }
        if (measurement instanceof WithShutter other) {
            Studio changed = studio().withCamera(studio().camera().withShutter(other.shutter()));
            return with(changed, caption + ", with the other shutter")
                    .measure(other.measurement(), path + ".measurement");
        }
        if (measurement instanceof OnRide ridden) {
            RideMoment moment = at(path, () -> RideMoment.onRide(studio(), ridden.properTime()));
            String time = NumberText.of(ridden.properTime());
            return with(moment.studio(), "On the ride, after " + time + " by the clock on board")
                    .measure(ridden.measurement(), path + ".measurement");
        }
        pictures.putIfAbsent(studio(), caption);
        return at(path, () -> read(measurement));
    }

    private Studio studio(WithNumber other) {
        if (isControl(other)) {
            control.requireReached("value", other.value());
        }
        return StudioNumber.at(other.number(), studio()).with(studio(), other.value());
    }

    private boolean isControl(WithNumber other) {
        return StudioPath.parse(other.number()).equals(StudioPath.parse(control.number()));
    }

    /** The value of a measurement that is not made from others. */
    private double read(Measurement measurement) {
        if (measurement instanceof RayReading reading) {
            return read(Sighting.required(plan, marked(reading.point()), 0, 0), reading.value());
        }
        if (measurement instanceof AngleBetween angle) {
            Vector2dc first = marked(angle.first());
            Vector2dc second = marked(angle.second());
            lines.add(List.of(first, second));
            return Math.toDegrees(Angles.between(direction(first), direction(second)));
        }
        if (measurement instanceof CircleRadius circle) {
            List<Vector2dc> outline = Outline.around(plan, inPixels(circle.across(), circle.down()));
            lines.add(outline);
            lines.add(List.of(outline.get(outline.size() - 1), outline.get(0)));
            return Math.toDegrees(Outline.angularRadius(plan, outline));
        }
        if (measurement instanceof StarCount count) {
            double angle = Math.toRadians(count.withinDegrees());
            lines.addAll(LookCone.around(studio().velocity().direction(), angle).lines(Projection.of(studio())));
            return studio().background() instanceof StarSky sky ? StarSighting.count(sky, studio(), angle) : Double.NaN;
        }
        LensSpread spread = (LensSpread) measurement;
        return LensWays.spread(plan, marked(new PicturePoint(spread.across(), spread.down())));
    }

    private static double read(Sighting sighting, RayValue value) {
        return switch (value) {
            case X -> emission(sighting).x();
            case Y -> emission(sighting).y();
            case Z -> emission(sighting).z();
            case TIME -> emission(sighting).time();
            case OWN_TIME -> seen(sighting).rest().event().time();
            case FREQUENCY_RATIO -> sighting.dopplerFactor();
            case BRIGHTNESS -> sighting.brightness();
        };
    }

    private static SampleHistory.Encounter seen(Sighting sighting) {
        if (sighting.hit() == null) {
            throw new InvalidPropertyException("point", "where an object is seen", "one where none is");
        }
        return sighting.hit();
    }

    private static Event emission(Sighting sighting) {
        return seen(sighting).inScene(sighting.studio().sceneFromCamera());
    }

    private Vector3dc direction(Vector2dc pixel) {
        return Sighting.required(plan, pixel, 0, 0).cameraDirection();
    }

    private Vector2dc marked(MeasuringPoint point) {
        Vector2dc pixel = inPixels(point);
        points.add(pixel);
        return pixel;
    }

    /** Whether another studio shows the same scene from the same camera, at another time perhaps. */
    private boolean isOneView(Studio other) {
        return other.withCamera(other.camera().withShutter(studio().camera().shutter()))
                .equals(studio());
    }

    private void add(Sketch other) {
        points.addAll(other.points());
        lines.addAll(other.lines());
    }

    /**
     * Where it measured since it was last asked: in its own picture, and in those that the camera takes with the same
     * velocity of the same scene, such as later ones. What was measured in others is left out.
     */
    Sketch sketch() {
        Sketch sketch = new Sketch(points, lines);
        points.clear();
        lines.clear();
        return sketch;
    }

    /** The position of a point in pixels. */
    private Vector2dc inPixels(MeasuringPoint point) {
        if (point instanceof PicturePoint given) {
            return inPixels(given.across(), given.down());
        }
        PictureEdge edge = (PictureEdge) point;
        List<Vector2dc> found = new Edges(plan)
                .on(inPixels(edge.across(), edge.down()), inPixels(edge.toAcross(), edge.toDown()), edge.count());
        if (found.size() < edge.count()) {
            String allowed = found.isEmpty()
                    ? "that of an edge, and there is none on this way"
                    : "at most " + found.size() + ", for there are no more edges on this way";
            throw new InvalidPropertyException("count", allowed, edge.count());
        }
        return found.get(edge.count() - 1);
    }

    private Vector2d inPixels(double across, double down) {
        return new Vector2d(across * plan.width(), down * plan.height());
    }

    private Studio studio() {
        return plan.studio();
    }

    /** Does some work; what it refuses is reported for a part of the studio. */
    static <T> T at(String path, Supplier<T> work) {
        try {
            return work.get();
        } catch (InvalidPropertyException wrong) {
            throw new InvalidPropertyException(path, wrong);
        }
    }
}
