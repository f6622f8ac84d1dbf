/** Numbers of the studio that run from one value to another, and the files that they make. */
package tompkins.animation;
