package tompkins.light;

import tompkins.ray.Hit;
import tompkins.ray.Padded;
import tompkins.ray.Ray;

/** The way from a point of a surface to a lamp, as light has come along it. Memory that is used again. */
public final class Sightline extends Padded {

    /** Up to here a whole power is quicker by squaring than by a logarithm. */
    private static final int LARGEST_WHOLE = 1024;

    /** From the point to where the lamp was when the light left it, in the frame of the surface. */
    public double x;

    public double y;
    public double z;

    /** Length of that way. */
    public double length;

    /** When the light left the lamp, in the own time of the lamp. */
    public double emission;

    /** Frequency of the light in the frame of the surface divided by that in the frame of the lamp. */
    public double dopplerFactor;

    /** Time that the light takes per unit length, in the frame of the surface: 1 except in a Galilean world. */
    public double slowness;

    /**
     * Sets the way to a lamp that rests in the frame of the surface, where light arrives at an own time of the lamp.
     */
    public void set(double newX, double newY, double newZ, double arrival) {
        set(newX, newY, newZ, 1, 1, arrival);
        emission = arrival - length;
    }

    /** Sets the way to a lamp. */
    public void set(
            double newX, double newY, double newZ, double newDopplerFactor, double newSlowness, double newEmission) {
        x = newX;
        y = newY;
        z = newZ;
        length = Math.sqrt(newX * newX + newY * newY + newZ * newZ);
        dopplerFactor = newDopplerFactor;
        slowness = newSlowness;
        emission = newEmission;
    }

    /** Whether the light of a lamp that shines so comes to the side of a surface that a ray has hit. */
    public boolean reaches(Ray ray, Hit hit, Flash flash) {
        boolean isBehind = alongNormal(hit) * hit.cosine(ray) > 0;
        return !isBehind && length > 0 && flash.isLit(emission);
    }

    /** The part of the light that dull colours send back: the cosine between normal and light. */
    double dullness(Hit hit) {
        return Math.abs(alongNormal(hit)) / length;
    }

    /** The highlight: a power of the cosine between the mirrored light and the ray (Phong's model). */
    double shine(Ray ray, Hit hit, double exponent) {
        // both point into the surface
        double mirrored = 2 * alongNormal(hit);
        double mx = x - mirrored * hit.normalX;
        double my = y - mirrored * hit.normalY;
        double mz = z - mirrored * hit.normalZ;
        double along = mx * ray.dx + my * ray.dy + mz * ray.dz;
        return along > 0 ? power(Math.min(1, along / Math.sqrt(mx * mx + my * my + mz * mz)), exponent) : 0;
    }

    /**
     * {@code base} to the power of {@code exponent}, neither of them negative. A whole exponent is worked out by
     * squaring: four times as fast as {@link Math#pow}, the same on every machine, and right to {@code exponent} times
     * 2^-53.
     */
    static double power(double base, double exponent) {
        int whole = (int) exponent;
        if (whole != exponent || whole > LARGEST_WHOLE) {
            return Math.pow(base, exponent);
        }
        double power = 1;
        double square = base;
        for (int left = whole; left > 0; left >>= 1) {
            if ((left & 1) == 1) {
                power *= square;
            }
            square *= square;
        }
        return power;
    }

    private double alongNormal(Hit hit) {
        return x * hit.normalX + y * hit.normalY + z * hit.normalZ;
    }
}
