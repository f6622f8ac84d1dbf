/**
 * Shapes, placed and ready to be met by rays. Of the descriptions from which they are made they know the surface, and
 * an object by what {@link tompkins.primitive.Described} says.
 */
package tompkins.primitive;
