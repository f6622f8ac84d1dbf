/** Where the shutter is and when it opens: the time at which each ray crosses the lens. */
package tompkins.shutter;
