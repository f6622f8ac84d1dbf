/**
 * What lights the scene: sources, how a surface point sends their light back along a ray, and what the motion of the
 * camera does to it.
 */
package tompkins.light;
