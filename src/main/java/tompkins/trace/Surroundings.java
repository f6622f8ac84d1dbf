package tompkins.trace;

import tompkins.light.Lighting;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;
import tompkins.spacetime.TransformationLaw;

/** What the rays of a tracer can meet, and what light gets there. One for each thread. */
interface Surroundings extends Lighting {

    /**
     * Begins a packet: searches for all its rays together as far as that helps, and forgets what was seen before, so
     * that the work for a packet depends on nothing else.
     */
    void begin(RayPacket rays);

    /** Whether a ray of that packet may meet something; false only if that is certain. */
    boolean mayMeet(int place);

    /**
     * Searches for the nearest hit of a ray of that packet, in the order of the places, and says whether there is one.
     */
    boolean nearest(int place);

    /** Searches for the nearest hit of a ray, and says whether there is one. */
    boolean nearest(Ray ray);

    /** The ray whose hit was found last, in the frame of what it has hit. Memory that is used again. */
    Ray met();

    /** The law by which coordinates change between frames. */
    TransformationLaw law();

    /** The hit that was found last, in memory that may be used again. */
    Hit hit(Hit memory);

    /**
     * The ray that goes on from a hit.
     *
     * @param weight what becomes of its light on the way to the camera
     */
    Ray goesOn(Ray next, Colour weight);

    /** A ray that meets nothing, in the frame of the tracer. Memory that is used again. */
    Ray leaving(Ray ray);
}
