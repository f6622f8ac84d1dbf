/** From a studio to the colour of one sample: what a picture needs, and the path of its rays through the frames. */
package tompkins.trace;
