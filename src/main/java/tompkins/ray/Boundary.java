package tompkins.ray;

/**
 * A surface in space on which rays end and start. All that a ray knows of objects: it lets an object recognise a ray
 * that starts on it, so that the ray is kept from hitting the same point again by geometry and not by a small number.
 */
public interface Boundary {

    /** What the clock of the object shows at time 0 of its frame. */
    double clockOffset();
}
