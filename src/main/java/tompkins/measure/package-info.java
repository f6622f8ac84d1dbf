/**
 * Measuring in photographs: where a picture shows a point, a direction or an outline, what pixels say about angles,
 * lengths and times, and what lessons measure in their pictures. It uses closed formulas and not a second way to trace
 * rays.
 */
package tompkins.measure;
