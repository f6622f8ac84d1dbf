package tompkins.experiment;

import java.util.List;
import org.joml.Vector3dc;
import tompkins.lesson.AngleBetween;
import tompkins.lesson.CircleRadius;
import tompkins.lesson.DifferenceOf;
import tompkins.lesson.LensSpread;
import tompkins.lesson.Measurement;
import tompkins.lesson.MeasuringPoint;
import tompkins.lesson.PictureEdge;
import tompkins.lesson.PicturePoint;
import tompkins.lesson.RatioOf;
import tompkins.lesson.RayReading;
import tompkins.lesson.WithNumber;
import tompkins.lesson.WithShutter;
import tompkins.measure.Angles;
import tompkins.property.InvalidPropertyException;
import tompkins.studio.Studio;
import tompkins.studio.StudioNumber;

/**
 * Measures the measurements of lessons in the picture of one studio. It only follows rays, which takes milliseconds.
 */
public final class Experiment {

    private final Studio studio;
    private final PictureRays rays;
    private final Edges edges;

    /**
     * An experiment with a studio.
     *
     * @throws InvalidPropertyException if an object of the studio is too large or too small to work with
     */
    public Experiment(Studio studio) {
        this.studio = studio;
        rays = new PictureRays(studio);
        edges = new Edges(rays);
    }

    /**
     * The value of a measurement: lengths and times in scene units, angles in degrees.
     *
     * @throws InvalidPropertyException if it cannot be measured here: the edge, the object or the number is missing
     */
    public double measure(Measurement measurement) {
        double measured = value(measurement);
        if (!Double.isFinite(measured)) {
            throw new InvalidPropertyException("measurement", "one that has a value in this picture", measured);
        }
        return measured;
    }

    private double value(Measurement measurement) {
        if (measurement instanceof RayReading reading) {
            return rays.read(place(reading.point()), reading.value());
        }
        if (measurement instanceof AngleBetween angle) {
            return Math.toDegrees(Angles.between(direction(angle.first()), direction(angle.second())));
        }
        if (measurement instanceof CircleRadius circle) {
            return new Outline(rays, edges).angularRadiusDegrees(new Place(circle.across(), circle.down()));
        }
        if (measurement instanceof LensSpread spread) {
            return new LensWays(rays).spread(new Place(spread.across(), spread.down()));
        }
        if (measurement instanceof DifferenceOf difference) {
            return measure(difference.first()) - measure(difference.second());
        }
        if (measurement instanceof RatioOf ratio) {
            return measure(ratio.first()) / measure(ratio.second());
        }
        if (measurement instanceof WithNumber other) {
            Studio changed = StudioNumber.at(other.number(), studio).with(studio, other.value());
            return new Experiment(changed).measure(other.measurement());
        }
        WithShutter other = (WithShutter) measurement;
        Studio changed = studio.withCamera(studio.camera().withShutter(other.shutter()));
        return new Experiment(changed).measure(other.measurement());
    }

    private Vector3dc direction(MeasuringPoint point) {
        return rays.at(place(point)).cameraDirection();
    }

    private Place place(MeasuringPoint point) {
        if (point instanceof PicturePoint given) {
            return new Place(given.across(), given.down());
        }
        PictureEdge edge = (PictureEdge) point;
        List<Place> found = edges.on(
                new Place(edge.across(), edge.down()), new Place(edge.toAcross(), edge.toDown()), edge.count());
        if (found.size() < edge.count()) {
            String allowed = found.isEmpty()
                    ? "that of an edge, and there is none on this way"
                    : "at most " + found.size() + ", for there are no more edges on this way";
            throw new InvalidPropertyException("count", allowed, edge.count());
        }
        return found.get(edge.count() - 1);
    }
}
