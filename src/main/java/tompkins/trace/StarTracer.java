package tompkins.trace;

import java.util.function.Function;
import tompkins.camera.EyeView;
import tompkins.camera.SamplePositions;
import tompkins.ray.Colour;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;

/** The light of rays that leave all objects of a scene under a sky of stars. One for each thread. */
final class StarTracer implements EscapedLight {

    private final StarField stars;
    private final CentreRays centre;
    private final Ray memory = Ray.blank();
    private EyeView eye;
    private int column;
    private int row;
    private double spread;

    /** The light of stars; the function makes a tracer of the same picture, without them, that an observer watches. */
    StarTracer(StarField stars, Function<PathObserver, SampleTracer> tracerFor) {
        this.stars = stars;
        centre = new CentreRays(tracerFor);
    }

    /**
     * Begins with a sample.
     *
     * @param seeing the eye in whose picture the places are
     * @param newSpread the opening angle with which its ray has left the camera
     */
    void begin(EyeView seeing, SamplePositions places, int sample, double newSpread) {
        eye = seeing;
        column = places.column(sample);
        row = places.row(sample);
        spread = newSpread;
        centre.begin(seeing, places, sample);
    }

    @Override
    public Colour colour(Ray ray) {
        Colour even = stars.evenLight();
        return stars.areShifted() ? even : even.plus(stars(ray));
    }

    @Override
    public Colour colour(RayPacket rays, int place) {
        return colour(rays.copy(place, memory));
    }

    @Override
    public Colour seen(Ray ray, Surroundings surroundings) {
        return surroundings.seen(stars.evenLight(), ray, 1).plus(stars(ray).times(ray.weight));
    }

    private Colour stars(Ray ray) {
        if (stars.isDirect(ray)) {
            return stars.direct(eye, column, row);
        }
        Ray central = centre.insteadOf(ray);
        double pixelAngle = Math.sqrt(stars.solidAngle(eye, column, row));
        return central == null
                ? stars.along(ray, pixelAngle, ray.spread / spread)
                : stars.along(central, pixelAngle, central.spread / centre.spread());
    }
}
