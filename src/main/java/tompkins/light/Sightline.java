package tompkins.light;

import tompkins.ray.Padded;

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
}
