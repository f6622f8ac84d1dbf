/** The program as a library: scenes, pictures, rays and measurements for programs of other people. */
package tompkins.lab;
