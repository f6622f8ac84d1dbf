/** Numerically stable arithmetic: differences of products, unit vectors, bases. */
package tompkins.math;
