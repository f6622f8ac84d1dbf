/** The inertial frames of a scene: what rests in each, the ways between them, and the search through all of them. */
package tompkins.world;
