package tompkins.trace;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import tompkins.camera.EyeView;
import tompkins.camera.SamplePositions;
import tompkins.ray.Colour;
import tompkins.ray.Padded;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;
import tompkins.trace.NearbyRays.Leaving;

/**
 * The light of rays that leave all objects of a scene under a sky of stars. One for each thread.
 *
 * <p>Behind mirrors, windows and glass the place in the picture at which a star is seen is sought by Newton's method
 * with real rays, and the star is drawn there as one that is seen directly. So its light depends neither on where in
 * the pixel samples lie, nor on where in a pixel the star stands, however the surfaces are curved.
 */
final class StarTracer extends Padded implements EscapedLight, StarMap.Visitor {

    /** The largest angle in which a star is sought, in radians. */
    private static final double WIDEST = 1;

    /** So far from the middle of a pixel stars are sought, in pixels: more than their spots, where ways are curved. */
    private static final double REACH = StarPoints.RADIUS + 0.5;

    /** By this part of a step directions may differ from those of the slope at its start. */
    private static final double LINEAR = 0.003;

    /** For rays that bring no more, such as those that glass mirrors many times, the slope of the sample is enough. */
    private static final double FAINT = 0.003;

    /** So is it for a star that brings no more than this part of what the pixel gets of all stars. */
    private static final double ONE_OF_MANY = 0.01;

    /** How far, in pixels, a star may be from where the slope of the sample puts it. */
    private static final double ASTRAY = 1;

    /** A step so short, in pixels, leads to the star. */
    private static final double SHORT = 0.02;

    /** So many rays are tried; at an edge about half of them lead beyond it. */
    private static final int TRIES = 16;

    private final StarField stars;
    private final NearbyRays nearby;
    private final Ray memory = Ray.blank();
    private final Leaving here = new Leaving();
    private final Leaving there = new Leaving();
    private final SkySlope first = new SkySlope();
    private final SkySlope[] next = {new SkySlope(), new SkySlope()};
    private EyeView eye;
    private int column;
    private int row;
    private long way;
    private Colour sum;

    /** Stars near the ray of now. */
    private final List<Near> near = new ArrayList<>();

    /** A star that may be near a ray, its direction, and the most of its brightness that the pixel can get. */
    private record Near(int star, double x, double y, double z, double brightness) {}

    /** The light of stars; the function makes a tracer of the same picture, without them, that an observer watches. */
    StarTracer(StarField stars, Function<PathObserver, SampleTracer> tracerFor) {
        this.stars = stars;
        nearby = new NearbyRays(tracerFor);
    }

    /**
     * Begins with a sample.
     *
     * @param seeing the eye in whose picture the places are
     */
    void begin(EyeView seeing, SamplePositions places, int sample) {
        eye = seeing;
        column = places.columns[sample];
        row = places.rows[sample];
        nearby.begin(seeing, places, sample);
    }

    @Override
    public Colour colour(Ray ray) {
        return stars.between(ray).plus(stars(ray).times(ray.weight));
    }

    @Override
    public Colour colour(RayPacket rays, int index) {
        return colour(rays.copy(index, memory));
    }

    private Colour stars(Ray ray) {
        if (stars.isDirect(ray)) {
            return stars.direct(eye, column, row);
        }
        NearbyRays.Left like = nearby.at(nearby.x(), nearby.y(), here).like(ray);
        if (like == null) {
            return Colour.BLACK;
        }
        way = like.way();
        if (!first.measure(nearby, nearby.x(), nearby.y(), here, like.ray(), way)) {
            return Colour.BLACK;
        }
        sum = Colour.BLACK;
        near.clear();
        // the sample is not in the middle of its pixel
        stars.visit(ray, Math.min(WIDEST, (REACH + 1) * first.steepest()), this);
        double all = 0;
        for (Near star : near) {
            all += star.brightness;
        }
        for (Near star : near) {
            seek(star, first.ray().throughput < FAINT || star.brightness < ONE_OF_MANY * all);
        }
        return sum.times(1 / stars.solidAngle(eye, column, row));
    }

    /** Keeps a star, wherever it may be near its place by the slope of the sample. */
    @Override
    public void take(int star, double starX, double starY, double starZ) {
        first.aim(first.ray(), starX, starY, starZ);
        double aside = length(first.x() + first.stepX() - column - 0.5, first.y() + first.stepY() - row - 0.5);
        double fraction = StarPoints.fraction(Math.max(0, aside - ASTRAY), 0);
        if (fraction > 0) {
            near.add(new Near(star, starX, starY, starZ, fraction * stars.brightness(star)));
        }
    }

    private void seek(Near star, boolean isFaint) {
        SkySlope slope = first;
        slope.aim(slope.ray(), star.x, star.y, star.z);
        double stepX = slope.stepX();
        double stepY = slope.stepY();
        double part = 1;
        boolean beyondEdge = isFaint;
        for (int i = 0; i < TRIES && !isFaint && isNear(slope.x() + stepX, slope.y() + stepY); i++) {
            double x = slope.x() + part * stepX;
            double y = slope.y() + part * stepY;
            Ray found = nearby.at(x, y, there).onWay(way, slope.ray());
            beyondEdge = found == null;
            if (beyondEdge) {
                part /= 2;
                continue;
            }
            slope.aim(found, star.x, star.y, star.z);
            double length = length(stepX, stepY);
            double remainderX = slope.stepX() - (1 - part) * stepX;
            double remainderY = slope.stepY() - (1 - part) * stepY;
            if (length(remainderX, remainderY) <= LINEAR * part * length
                    && Math.abs(turn(found) / turn(slope.ray()) - 1) <= LINEAR) {
                add(star.star, found, slope, x + slope.stepX(), y + slope.stepY());
                return;
            }
            SkySlope nearer = slope == next[0] ? next[1] : next[0];
            if (length(slope.stepX(), slope.stepY()) >= length || !nearer.measure(nearby, x, y, there, found, way)) {
                part /= 2;
                continue;
            }
            slope = nearer;
            slope.aim(slope.ray(), star.x, star.y, star.z);
            stepX = slope.stepX();
            stepY = slope.stepY();
            part = 1;
            if (length(stepX, stepY) < SHORT) {
                add(star.star, slope.ray(), slope, x + stepX, y + stepY);
                return;
            }
        }
        if (beyondEdge) {
            // as if what shows the star went on beyond its edge
            add(star.star, slope.ray(), slope, slope.x() + stepX, slope.y() + stepY);
        }
    }

    private static double turn(Ray ray) {
        return ray.windowFactor * ray.directionLength;
    }

    private static double length(double x, double y) {
        return Math.sqrt(x * x + y * y);
    }

    private boolean isNear(double x, double y) {
        return length(x - column - 0.5, y - row - 0.5) < REACH;
    }

    /** Adds the light of a star at a place, of which a ray there brings as much as it can. */
    private void add(int star, Ray ray, SkySlope slope, double x, double y) {
        double fraction = StarPoints.fraction(column + 0.5 - x, row + 0.5 - y);
        if (fraction > 0) {
            double brought = ray.throughput / first.ray().throughput;
            sum = sum.plus(stars.light(star, slope.ray()).times(fraction * brought * slope.magnification()));
        }
    }
}
