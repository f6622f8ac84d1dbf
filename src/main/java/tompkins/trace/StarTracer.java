package tompkins.trace;

import tompkins.ray.Colour;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;
import tompkins.studio.Background;

/** The light of rays that leave all objects of a scene under a sky of stars. One for each thread. */
final class StarTracer implements EscapedLight {

    private final Background sky;
    private final StarField stars;

    /** Whether surroundings shift light where it leaves a hit; otherwise it stays as it is. */
    private final boolean shifts;

    private final Ray memory = Ray.blank();
    private int column;
    private int row;
    private double spread;

    StarTracer(Background sky, StarField stars, boolean shifts) {
        this.sky = sky;
        this.stars = stars;
        this.shifts = shifts;
    }

    /**
     * Begins with a sample of a pixel.
     *
     * @param newSpread the opening angle with which its ray has left the camera
     */
    void begin(int pixelColumn, int pixelRow, double newSpread) {
        column = pixelColumn;
        row = pixelRow;
        spread = newSpread;
    }

    @Override
    public Colour colour(Ray ray) {
        Colour even = even(ray);
        return shifts ? even : even.plus(stars(ray));
    }

    @Override
    public Colour colour(RayPacket rays, int place) {
        return colour(rays.copy(place, memory));
    }

    @Override
    public Colour seen(Ray ray, Surroundings surroundings) {
        return surroundings.seen(even(ray), ray, 1).plus(stars(ray).times(ray.weight));
    }

    private Colour even(Ray ray) {
        return sky.colour(ray.dx, ray.dy, ray.dz, Math.abs(ray.spread));
    }

    private Colour stars(Ray ray) {
        return stars.isDirect(ray)
                ? stars.direct(column, row)
                : stars.along(ray, Math.sqrt(stars.solidAngle(column, row)), ray.spread / spread);
    }
}
