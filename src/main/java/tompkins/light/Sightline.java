package tompkins.light;

import tompkins.math.Powers;
import tompkins.ray.Hit;
import tompkins.ray.Padded;
import tompkins.ray.Ray;

/** The way from a point of a surface to a lamp, as light has come along it. Memory that is used again. */
public final class Sightline extends Padded {

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
        return along > 0 ? Powers.power(Math.min(1, along / Math.sqrt(mx * mx + my * my + mz * mz)), exponent) : 0;
    }

    private double alongNormal(Hit hit) {
        return x * hit.normalX + y * hit.normalY + z * hit.normalZ;
    }
}
