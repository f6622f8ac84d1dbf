/**
 * What a description says of itself: the meaning and unit of each property, and the check of each value; and how to
 * read and build descriptions without knowing them. Scene files, forms and the reference in {@code docs} all read the
 * same annotations and show the same messages.
 */
package tompkins.property;
