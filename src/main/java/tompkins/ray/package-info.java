/** Plain values that travel through the tracer: rays, colours, hits, pictures as numbers. */
package tompkins.ray;
