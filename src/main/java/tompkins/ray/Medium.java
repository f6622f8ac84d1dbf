package tompkins.ray;

/**
 * A transparent medium, such as glass, in which light is.
 *
 * @param index its refractive index: in its rest frame, and only there, light takes this time per unit length in all
 *     directions
 * @param frame the number of that frame
 * @param outer the medium around it, into which light comes where it leaves this one; null for vacuum
 */
public record Medium(double index, int frame, Medium outer) {}
