/**
 * The renderer: tiles of the picture on all cores, in passes, with progress and cancel; whole photographs one by one.
 */
package tompkins.render;
