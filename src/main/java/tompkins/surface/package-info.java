/** What happens to a ray at a boundary: the surfaces, and what a surface may ask of the tracer. */
package tompkins.surface;
