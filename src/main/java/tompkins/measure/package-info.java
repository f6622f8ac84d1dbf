/**
 * Measuring in photographs: where a picture shows a point, a direction or an outline, and what pixels tell of angles,
 * lengths and times. Closed formulas, not a second way to trace rays.
 */
package tompkins.measure;
