/** The program: its command line and its start. */
package tompkins.app;
