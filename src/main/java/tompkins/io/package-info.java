/**
 * Scene files: JSON with comments, one file for one {@link tompkins.studio.Studio}. A file becomes a
 * {@link tompkins.io.JsonValue tree of values that know their places}; the tree becomes records, whose components are
 * the keys and whose constructors check the values. No member of a family is mentioned by name, except those that are
 * meant if a file names no type: a new member can be read, written and looked up in the reference as soon as its family
 * permits it. Values with a form of their own, such as vectors, colours and pictures, are mentioned. Nothing outside
 * this package knows Jackson.
 */
package tompkins.io;
