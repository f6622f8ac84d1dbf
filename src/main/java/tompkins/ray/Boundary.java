package tompkins.ray;

/**
 * A surface in space on which rays end and start. This is all that a ray knows of objects. It lets an object recognise
 * a ray that starts on it, so that geometry, and not a small number, keeps the ray from hitting the same point again.
 */
public interface Boundary {

    /** What a clock of the object shows at a hit on it. */
    double clockReading(Hit hit);
}
