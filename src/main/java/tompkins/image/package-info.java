/**
 * Photographs as numbers, the tone curve that turns them into levels, and the files that hold them: photographs with
 * the scene inside, animations, and pictures of other programs. The readers and writers of the image formats are chosen
 * in one place, {@code ImageProviders}.
 */
package tompkins.image;
