/**
 * Arithmetic that keeps its digits: differences of products, unit vectors, bases. It knows nothing of rays or
 * relativity.
 */
package tompkins.math;
