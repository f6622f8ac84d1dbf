/** Arithmetic that keeps its digits: differences of products, unit vectors, bases. No domain words. */
package tompkins.math;
