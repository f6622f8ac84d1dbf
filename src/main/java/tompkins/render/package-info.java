/** The renderer: tiles of the picture on all cores, in passes, with progress and cancel. */
package tompkins.render;
