package tompkins.light;

/** The way from a point of a surface to a lamp, as light has come along it. Memory that is used again. */
public final class Sightline {

    /** From the point to where the lamp was when the light left it, in the frame of the surface. */
    public double x;

    public double y;
    public double z;

    /** Frequency of the light in the frame of the surface divided by that in the frame of the lamp. */
    public double dopplerFactor;

    /** Time that the light takes per unit length, in the frame of the surface: 1 except in a Galilean world. */
    public double slowness;

    /** Sets the way to a lamp that rests in the frame of the surface. */
    public void set(double newX, double newY, double newZ) {
        set(newX, newY, newZ, 1, 1);
    }

    /** Sets the way to a lamp. */
    public void set(double newX, double newY, double newZ, double newDopplerFactor, double newSlowness) {
        x = newX;
        y = newY;
        z = newZ;
        dopplerFactor = newDopplerFactor;
        slowness = newSlowness;
    }
}
