/** What lights the scene: sources, and how a surface point sends their light back along a ray. */
package tompkins.light;
