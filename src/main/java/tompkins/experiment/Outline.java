package tompkins.experiment;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3dc;
import tompkins.measure.CircleFit;
import tompkins.property.InvalidPropertyException;

/** The outline of something in a picture: where the first edge is met on the way outwards in many directions. */
final class Outline {

    private static final int WAYS = 64;

    private final PictureRays rays;
    private final Edges edges;

    /** Outlines in a picture. */
    Outline(PictureRays rays, Edges edges) {
        this.rays = rays;
        this.edges = edges;
    }

    /**
     * The angular radius, in degrees, of the circle of directions that fits the outline around a place best.
     *
     * @throws InvalidPropertyException if there is no edge in some direction
     */
    double angularRadiusDegrees(Place inside) {
        return Math.toDegrees(CircleFit.of(directions(inside)).circle().halfAngle());
    }

    /** The directions in which the camera sees points of the outline. */
    private List<Vector3dc> directions(Place inside) {
        List<Vector3dc> directions = new ArrayList<>();
        double shape = (double) rays.plan().width() / rays.plan().height();
        for (int i = 0; i < WAYS; i++) {
            double angle = 2 * Math.PI * i / WAYS;
            Place outside = atTheBorder(inside, Math.cos(angle), shape * Math.sin(angle));
            List<Place> found = edges.on(inside, outside, 1);
            if (found.isEmpty()) {
                throw new InvalidPropertyException(
                        "across", "inside an outline that ends in the picture", inside.across());
            }
            directions.add(rays.at(found.get(0)).cameraDirection());
        }
        return directions;
    }

    /** Where the way from a place in a direction leaves the picture. */
    private static Place atTheBorder(Place from, double across, double down) {
        double length = Math.min(length(from.across(), across), length(from.down(), down));
        return new Place(from.across() + length * across, from.down() + length * down);
    }

    /** How long it takes to leave the range from 0 to 1. */
    private static double length(double from, double speed) {
        return speed == 0 ? Double.POSITIVE_INFINITY : speed > 0 ? (1 - from) / speed : -from / speed;
    }
}
