package tompkins.light;

import tompkins.ray.Hit;

/** Whether light gets from one place to another. */
@FunctionalInterface
public interface Visibility {

    /** Whether nothing that throws a shadow lies between a hit and the place (x, y, z), in the frame of the hit. */
    boolean isClear(Hit from, double x, double y, double z);
}
