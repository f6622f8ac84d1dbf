/** Shapes, placed and ready to be met by rays. They know nothing of the descriptions from which they are made. */
package tompkins.primitive;
