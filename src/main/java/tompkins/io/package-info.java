/**
 * Scene files: JSON with comments, one file for one {@link tompkins.studio.Studio}. A file becomes a
 * {@link tompkins.io.JsonValue tree of values that know their places}; the tree becomes records, whose components are the
 * keys and whose constructors check the values. No type is mentioned by name, so that a new one can be read, written and
 * looked up in the reference as soon as it is permitted by its family. Nothing outside this package knows Jackson.
 */
package tompkins.io;
