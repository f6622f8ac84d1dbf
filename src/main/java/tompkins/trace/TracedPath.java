package tompkins.trace;

import tompkins.ray.Colour;
import tompkins.ray.Ray;

/**
 * The result of following a ray among the objects of a frame.
 *
 * @param light what the ray has brought by itself
 * @param throughput the part that arrives of the light that comes back to where the ray has left the objects
 * @param escaped the ray that has left the objects; null if it has ended there
 */
record TracedPath(Colour light, Colour throughput, Ray escaped) {}
